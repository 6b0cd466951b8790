#pragma once

#include <cstdint>
#include <string_view>

#include "idl/bus/sieve_words.h"
#include "idl/types/event.h"
#include "idl/wire/team.h"

namespace tacit {

/// Reads the member values of one happening, through a sieve.
class EventReader {
 public:
  EventReader(Sieve& sieve, const wire::Event& in) : sieve_(sieve), in_(in) {}

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
  void operator()(OperationBegun& e) {
    e.team = in_.number();
    e.extras = in_.other();
  }
  void operator()(ObjectTaken& e) { numbered(e.robot, e.object.value, kObject); }
  void operator()(ObjectDropped& e) {
    numbered(e.robot, e.object.value, kObject);
    e.position_m = position();
  }
  void operator()(ObjectStored& e) {
    numbered(e.robot, e.object.value, kObject);
    sieve_.pass(in_.other() != 0, "container is 0, wanted at least 1");
    e.container = {in_.other()};
  }
  void operator()(ObjectTested& e) {
    numbered(e.robot, e.object.value, kObject);
    e.finding = sieve_.code(in_.detail(), Finding::Dangerous, "unknown finding");
    sieve_.pass(e.finding != Finding::None, "a test without a finding");
  }
  void operator()(DoorwayMarked& e) {
    numbered(e.robot, e.doorway, "doorway is 0, wanted at least 1");
    e.marked = sieve_.flag(in_.detail(), "marked is neither 0 nor 1");
  }
  void operator()(SiteEntered& e) {
    e.robot = sieve_robot(sieve_, in_.robot());
    e.site = sieve_.code(in_.detail(), Site::Hallway, "unknown site");
    e.number = in_.number();
    sieve_.pass((e.site == Site::Open) == (e.number == 0), "site's number is not its kind's");
  }
  void operator()(PointReached& e) { numbered(e.robot, e.point, "point is 0, wanted at least 1"); }
  void operator()(Signalled& e) {
    said(e.robot, e.word);
    e.heard = in_.other();
  }
  void operator()(Alerted& e) { said(e.robot, e.word); }
  void operator()(RobotExposed& e) {
    e.robot = sieve_robot(sieve_, in_.robot());
    e.to = sieve_robot(sieve_, in_.other_robot());
    e.exposed = sieve_.flag(in_.detail(), "exposed is neither 0 nor 1");
  }
  void operator()(RobotFinished& e) { e.robot = sieve_robot(sieve_, in_.robot()); }
  void operator()(OperatorActed& e) {
    e.robot = sieve_robot(sieve_, in_.robot());
    e.act = sieve_.code(in_.detail(), OperatorAct::SkipGoal, "unknown act of an operator");
    e.joystick = sieve_joystick<WorldVec>(sieve_, in_.joystick_x(), in_.joystick_y());
  }

 private:
  static constexpr std::string_view kObject = "object is 0, wanted at least 1";

  void numbered(RobotId& robot, std::uint32_t& number, std::string_view what) {
    robot = sieve_robot(sieve_, in_.robot());
    sieve_.pass(in_.number() != 0, what);
    number = in_.number();
  }
  void said(RobotId& robot, Word& word) {
    robot = sieve_robot(sieve_, in_.robot());
    word = sieve_word(sieve_, std::string_view(in_.word().c_str(), in_.word().size()));
  }
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

}  // namespace tacit
