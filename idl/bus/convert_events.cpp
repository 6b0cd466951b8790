#include "idl/bus/convert_events.h"

#include <cassert>

#include "idl/bus/sieve_words.h"
#include "idl/wire/team.h"

namespace tacit {
namespace {

/// The position of a happening's type in `Happening` is its code on the wire.
template <std::size_t Index>
using HappeningAt = std::variant_alternative_t<Index, Happening>;

class Writer {
 public:
  explicit Writer(wire::Event& out) : out_(out) {}

  void operator()(const EnemyCreated& e) {
    out_.number(e.enemy.value);
    out_.detail(static_cast<std::uint8_t>(e.kind));
    out_.x_m(e.position_m.x());
    out_.y_m(e.position_m.y());
  }
  void operator()(const EnemyIntercepted& e) {
    out_.number(e.enemy.value);
    out_.detail(static_cast<std::uint8_t>(e.kind));
    out_.robot(e.robot.value);
    out_.distance_to_target_m(e.distance_to_target_m);
  }
  void operator()(const TargetHit& e) {
    out_.number(e.enemy.value);
    out_.distance_to_target_m(e.distance_to_target_m);
  }
  void operator()(const Collision& e) {
    out_.robot(e.robot.value);
    out_.detail(static_cast<std::uint8_t>(e.with));
    out_.number(e.other);
  }
  void operator()(const RobotLost& e) { out_.robot(e.robot.value); }
  void operator()(const RobotBack& e) { out_.robot(e.robot.value); }
  void operator()(const RobotLate& e) { out_.robot(e.robot.value); }
  void operator()(const Checkpoint& e) {
    out_.state_digest(e.state_digest);
    out_.number(e.enemies);
    out_.mean_distance_to_target_m(e.mean_distance_to_target_m);
    out_.mean_speed_mps(e.mean_speed_mps);
  }
  void operator()(const RunEnded& e) { out_.state_digest(e.state_digest); }
  void operator()(const EnemyRetreated& e) { out_.number(e.enemy.value); }
  void operator()(const MineTaken& e) { mine(e.robot, e.mine); }
  void operator()(const MineDropped& e) {
    mine(e.robot, e.mine);
    out_.x_m(e.position_m.x());
    out_.y_m(e.position_m.y());
  }
  void operator()(const MineStored& e) {
    mine(e.robot, e.mine);
    out_.left(e.left);
  }
  void operator()(const RobotDisabled& e) {
    out_.robot(e.robot.value);
    out_.detail(static_cast<std::uint8_t>(e.by));
  }
  void operator()(const RobotRevived& e) {
    out_.robot(e.robot.value);
    out_.other_robot(e.by.value);
  }
  void operator()(const MissionOver& e) {
    out_.detail(static_cast<std::uint8_t>(e.verdict));
    out_.score_ticks(e.score_ticks);
  }
  void operator()(const ForageBegun& e) { out_.left(e.mines); }

 private:
  void mine(RobotId robot, MineId mine) {
    out_.robot(robot.value);
    out_.number(mine.value);
  }

  wire::Event& out_;
};

/// Reads the member values of one happening.
class Reader {
 public:
  Reader(Sieve& sieve, const wire::Event& in) : sieve_(sieve), in_(in) {}

  void operator()(EnemyCreated& e) {
    e.enemy = enemy();
    e.kind = enemy_kind();
    e.position_m = position();
  }
  void operator()(EnemyIntercepted& e) {
    e.enemy = enemy();
    e.kind = enemy_kind();
    e.robot = sieve_robot(sieve_, in_.robot());
    e.distance_to_target_m = distance(in_.distance_to_target_m());
  }
  void operator()(TargetHit& e) {
    e.enemy = enemy();
    e.distance_to_target_m = distance(in_.distance_to_target_m());
  }
  void operator()(Collision& e) {
    e.robot = sieve_robot(sieve_, in_.robot());
    e.with = sieve_.code(in_.detail(), Obstruction::Enemy, "unknown obstruction");
    e.other = in_.number();
  }
  void operator()(RobotLost& e) { e.robot = sieve_robot(sieve_, in_.robot()); }
  void operator()(RobotBack& e) { e.robot = sieve_robot(sieve_, in_.robot()); }
  void operator()(RobotLate& e) { e.robot = sieve_robot(sieve_, in_.robot()); }
  void operator()(Checkpoint& e) {
    e.state_digest = in_.state_digest();
    e.enemies = in_.number();
    e.mean_distance_to_target_m = distance(in_.mean_distance_to_target_m());
    e.mean_speed_mps = sieve_.number(in_.mean_speed_mps(), 0.0, limits::kSpeedMps,
                                     "mean speed is not in 0 to 1e4 m/s");
  }
  void operator()(RunEnded& e) { e.state_digest = in_.state_digest(); }
  void operator()(EnemyRetreated& e) { e.enemy = enemy(); }
  void operator()(MineTaken& e) {
    e.robot = sieve_robot(sieve_, in_.robot());
    e.mine = mine();
  }
  void operator()(MineDropped& e) {
    e.robot = sieve_robot(sieve_, in_.robot());
    e.mine = mine();
    e.position_m = position();
  }
  void operator()(MineStored& e) {
    e.robot = sieve_robot(sieve_, in_.robot());
    e.mine = mine();
    e.left = in_.left();
  }
  void operator()(RobotDisabled& e) {
    e.robot = sieve_robot(sieve_, in_.robot());
    e.by = sieve_.code(in_.detail(), Mishap::Enemy, "unknown mishap");
  }
  void operator()(RobotRevived& e) {
    e.robot = sieve_robot(sieve_, in_.robot());
    e.by = sieve_robot(sieve_, in_.other_robot());
  }
  void operator()(MissionOver& e) {
    e.verdict = sieve_.code(in_.detail(), Verdict::OutOfTime, "unknown verdict");
    e.score_ticks = sieve_tick(sieve_, in_.score_ticks());
  }
  void operator()(ForageBegun& e) { e.mines = in_.left(); }

 private:
  EnemyId enemy() {
    sieve_.pass(in_.number() != 0, "enemy is 0, wanted at least 1");
    return {in_.number()};
  }
  EnemyKind enemy_kind() {
    return sieve_.code(in_.detail(), EnemyKind::Hunter, "unknown kind of enemy");
  }
  MineId mine() {
    sieve_.pass(in_.number() != 0, "mine is 0, wanted at least 1");
    return {in_.number()};
  }
  WorldVec position() {
    return sieve_vec<WorldVec>(sieve_, in_.x_m(), in_.y_m(), limits::kPositionM,
                               "position is not within 1e6 m");
  }
  double distance(double value_m) {
    return sieve_.number(value_m, 0.0, limits::kPositionM, "distance is not in 0 to 1e6 m");
  }

  Sieve& sieve_;
  const wire::Event& in_;
};

/// Makes `what` hold a fresh happening of the type with code `kind`; false when there is none.
template <std::size_t Index = 0>
bool hold(std::uint8_t kind, Happening& what) {
  if constexpr (Index == std::variant_size_v<Happening>) {
    return false;
  } else {
    if (kind != Index) return hold<Index + 1>(kind, what);
    what = HappeningAt<Index>{};
    return true;
  }
}

void to_wire(const Event& word, wire::Event& wire) {
  wire = wire::Event();
  wire.tick(word.tick);
  wire.kind(static_cast<std::uint8_t>(word.what.index()));
  std::visit(Writer(wire), word.what);
}

void from_wire(Sieve& sieve, const wire::Event& wire, Event& word) {
  word.tick = sieve_tick(sieve, wire.tick());
  if (sieve.pass(hold(wire.kind(), word.what), "unknown kind of event")) {
    std::visit(Reader(sieve, wire), word.what);
  }
}

}  // namespace

void to_wire(const EventBatch& word, wire::EventBatch& wire) {
  assert(word.events.size() <= EventBatch::kMaxEvents);
  wire.first(word.first);
  wire.events().resize(word.events.size());
  for (std::size_t i = 0; i < word.events.size(); ++i) to_wire(word.events[i], wire.events()[i]);
}

Flaw from_wire(const wire::EventBatch& wire, EventBatch& word) {
  Sieve sieve;
  word.first = wire.first();
  word.events.resize(
      sieve.count(wire.events().size(), EventBatch::kMaxEvents, "more events than a batch holds"));
  for (std::size_t i = 0; i < word.events.size(); ++i) {
    from_wire(sieve, wire.events()[i], word.events[i]);
  }
  return sieve.flaw();
}

}  // namespace tacit
