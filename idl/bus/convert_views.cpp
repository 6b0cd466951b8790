#include "idl/bus/convert_views.h"

#include <algorithm>

#include "idl/bus/sieve_words.h"
#include "idl/wire/team.h"

namespace tacit {
namespace {

constexpr std::size_t kName = 31;

void to_wire(const ViewedRobot& word, wire::ViewedRobot& wire) {
  wire.robot(word.robot.value);
  wire.x_m(word.pose.position_m.x());
  wire.y_m(word.pose.position_m.y());
  wire.heading_cos(word.pose.heading.cos);
  wire.heading_sin(word.pose.heading.sin);
  wire.velocity_x_mps(word.velocity_mps.x());
  wire.velocity_y_mps(word.velocity_mps.y());
  wire.present(word.present ? 1 : 0);
  wire.able(word.able ? 1 : 0);
  wire.holding(word.holding ? 1 : 0);
  wire.colour(static_cast<std::uint8_t>(word.colour));
}

void from_wire(Sieve& sieve, const wire::ViewedRobot& wire, ViewedRobot& word) {
  word.robot = sieve_robot(sieve, wire.robot());
  word.pose.position_m = sieve_vec<WorldVec>(sieve, wire.x_m(), wire.y_m(), limits::kPositionM,
                                             "robot is not within 1e6 m");
  word.pose.heading = sieve_heading(sieve, wire.heading_cos(), wire.heading_sin());
  word.velocity_mps = sieve_vec<WorldVec>(sieve, wire.velocity_x_mps(), wire.velocity_y_mps(),
                                          limits::kSpeedMps, "velocity is not within 1e4 m/s");
  word.present = sieve.flag(wire.present(), "present is neither 0 nor 1");
  word.able = sieve.flag(wire.able(), "able is neither 0 nor 1");
  word.holding = sieve.flag(wire.holding(), "holding is neither 0 nor 1");
  word.colour = sieve.code(wire.colour(), Colour::Grey, "unknown colour of a robot");
}

void to_wire(const ViewedEnemy& word, wire::ViewedEnemy& wire) {
  wire.enemy(word.enemy.value);
  wire.kind(static_cast<std::uint8_t>(word.kind));
  wire.x_m(word.position_m.x());
  wire.y_m(word.position_m.y());
}

void from_wire(Sieve& sieve, const wire::ViewedEnemy& wire, ViewedEnemy& word) {
  sieve.pass(wire.enemy() != 0, "enemy is 0, wanted at least 1");
  word.enemy = {wire.enemy()};
  word.kind = sieve.code(wire.kind(), EnemyKind::Hunter, "unknown kind of enemy");
  word.position_m = sieve_vec<WorldVec>(sieve, wire.x_m(), wire.y_m(), limits::kPositionM,
                                        "enemy is not within 1e6 m");
}

void to_wire(const ViewedMine& word, wire::ViewedMine& wire) {
  wire.mine(word.mine.value);
  wire.x_m(word.position_m.x());
  wire.y_m(word.position_m.y());
}

void from_wire(Sieve& sieve, const wire::ViewedMine& wire, ViewedMine& word) {
  sieve.pass(wire.mine() != 0, "mine is 0, wanted at least 1");
  word.mine = {wire.mine()};
  word.position_m = sieve_vec<WorldVec>(sieve, wire.x_m(), wire.y_m(), limits::kPositionM,
                                        "mine is not within 1e6 m");
}

void to_wire(const ViewedObject& word, wire::ViewedObject& wire) {
  wire.number(word.object.value);
  wire.x_m(word.position_m.x());
  wire.y_m(word.position_m.y());
  wire.radius_m(word.radius_m);
  wire.colour(static_cast<std::uint8_t>(word.colour));
}

void from_wire(Sieve& sieve, const wire::ViewedObject& wire, ViewedObject& word) {
  sieve.pass(wire.number() != 0, "object is 0, wanted at least 1");
  word.object = {wire.number()};
  word.position_m = sieve_vec<WorldVec>(sieve, wire.x_m(), wire.y_m(), limits::kPositionM,
                                        "object is not within 1e6 m");
  word.radius_m =
      sieve.number(wire.radius_m(), 0.0, limits::kRadiusM, "radius is not in 0 to 1e4 m");
  word.colour = sieve.code(wire.colour(), Colour::Grey, "unknown colour of an object");
}

void to_wire(const SchemaShare& word, wire::SchemaShare& wire) {
  wire.name(word.name.substr(0, kName));
  wire.gain(word.gain);
  wire.push_x(word.push.x());
  wire.push_y(word.push.y());
}

void from_wire(Sieve& sieve, const wire::SchemaShare& wire, SchemaShare& word) {
  sieve.text(wire.name(), kName, word.name, "schema's name is longer than 31 characters");
  word.gain = sieve.number(wire.gain(), -limits::kPush, limits::kPush, "gain is not within 1e9");
  word.push = sieve_vec<BodyVec>(sieve, wire.push_x(), wire.push_y(), limits::kPush,
                                 "push is not within 1e9");
}

template <class From, class To>
void list_to_wire(const std::vector<From>& from, std::vector<To>& to, std::size_t limit) {
  to.resize(std::min(from.size(), limit));
  for (std::size_t i = 0; i < to.size(); ++i) to_wire(from[i], to[i]);
}

template <class From, class To>
void list_from_wire(Sieve& sieve, const std::vector<From>& from, std::vector<To>& to) {
  to.resize(from.size());
  for (std::size_t i = 0; i < to.size(); ++i) from_wire(sieve, from[i], to[i]);
}

}  // namespace

void to_wire(const WorldView& word, wire::WorldView& wire) {
  wire.tick(word.tick);
  wire.time_s(word.time_s);
  list_to_wire(word.robots, wire.robots(), WorldView::kMaxBodies);
  list_to_wire(word.enemies, wire.enemies(), WorldView::kMaxBodies);
  list_to_wire(word.mines, wire.mines(), WorldView::kMaxBodies);
  list_to_wire(word.objects, wire.objects(), WorldView::kMaxBodies);
}

Flaw from_wire(const wire::WorldView& wire, WorldView& word) {
  Sieve sieve;
  word.tick = sieve_tick(sieve, wire.tick());
  word.time_s = sieve.number(wire.time_s(), 0.0, limits::kSimulatedS, "time is not in 0 to 1e12 s");
  sieve.pass(wire.robots().size() <= WorldView::kMaxBodies, "more robots than a view holds");
  sieve.pass(wire.enemies().size() <= WorldView::kMaxBodies, "more enemies than a view holds");
  sieve.pass(wire.mines().size() <= WorldView::kMaxBodies, "more mines than a view holds");
  sieve.pass(wire.objects().size() <= WorldView::kMaxBodies, "more objects than a view holds");
  if (sieve.flaw()) return sieve.flaw();
  list_from_wire(sieve, wire.robots(), word.robots);
  list_from_wire(sieve, wire.enemies(), word.enemies);
  list_from_wire(sieve, wire.mines(), word.mines);
  list_from_wire(sieve, wire.objects(), word.objects);
  return sieve.flaw();
}

void to_wire(const Telemetry& word, wire::Telemetry& wire) {
  wire.robot(word.robot.value);
  wire.tick(word.tick);
  wire.learner(word.learner.substr(0, kName));
  wire.situation(word.situation.substr(0, kName));
  wire.role(word.role.substr(0, kName));
  wire.state(word.state.substr(0, kName));
  wire.decisions(word.decisions);
  wire.duplicates(word.duplicates);
  wire.rejected(word.rejected);
  list_to_wire(word.shares, wire.shares(), Telemetry::kMaxShares);
}

Flaw from_wire(const wire::Telemetry& wire, Telemetry& word) {
  Sieve sieve;
  word.robot = sieve_robot(sieve, wire.robot());
  word.tick = sieve_tick(sieve, wire.tick());
  sieve.text(wire.learner(), kName, word.learner, "learner is longer than 31 characters");
  sieve.text(wire.situation(), kName, word.situation, "situation is longer than 31 characters");
  sieve.text(wire.role(), kName, word.role, "role is longer than 31 characters");
  sieve.text(wire.state(), kName, word.state, "state is longer than 31 characters");
  word.decisions = wire.decisions();
  word.duplicates = wire.duplicates();
  word.rejected = wire.rejected();
  sieve.pass(wire.shares().size() <= Telemetry::kMaxShares, "more shares than a telemetry holds");
  if (sieve.flaw()) return sieve.flaw();
  list_from_wire(sieve, wire.shares(), word.shares);
  return sieve.flaw();
}

}  // namespace tacit
