#include "idl/bus/convert_team.h"

#include <algorithm>
#include <limits>

#include "idl/bus/sieve_words.h"
#include "idl/wire/team.h"

namespace tacit {
namespace {

constexpr std::size_t kReason = 1023;
constexpr std::size_t kHost = 255;
constexpr std::size_t kVersion = 63;
constexpr std::size_t kName = 31;
constexpr std::size_t kDigest = 64;

bool is_sha256(const std::string& text) {
  return text.size() == kDigest && std::all_of(text.begin(), text.end(), [](char c) {
           return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'f');
         });
}

}  // namespace

void to_wire(const Order& word, wire::Order& wire) {
  wire.robot(word.robot.value);
  wire.incarnation(word.incarnation);
  wire.kind(static_cast<std::uint8_t>(word.kind));
  wire.reason(word.reason.substr(0, kReason));
}

Flaw from_wire(const wire::Order& wire, Order& word) {
  Sieve sieve;
  word.robot = sieve_robot(sieve, wire.robot());
  word.incarnation = wire.incarnation();
  word.kind = sieve.code(wire.kind(), OrderKind::Finish, "unknown kind of order");
  sieve.text(wire.reason(), kReason, word.reason, "reason is longer than 1023 characters");
  return sieve.flaw();
}

void to_wire(const Hello& word, wire::Hello& wire) {
  wire.robot(word.robot.value);
  wire.incarnation(word.incarnation);
  wire.pid(word.pid);
  wire.host(word.host.substr(0, kHost));
  wire.version(word.version.substr(0, kVersion));
  wire.learner(word.learner.substr(0, kName));
  wire.driver(word.driver.substr(0, kName));
  wire.scenario_digest(word.scenario_digest.substr(0, kDigest));
}

Flaw from_wire(const wire::Hello& wire, Hello& word) {
  Sieve sieve;
  word.robot = sieve_robot(sieve, wire.robot());
  word.incarnation = wire.incarnation();
  sieve.pass(word.incarnation != 0, "incarnation is 0");
  word.pid = sieve.whole<std::int32_t>(wire.pid(), 1, std::numeric_limits<std::int32_t>::max(),
                                       "pid is not positive");
  sieve.text(wire.host(), kHost, word.host, "host is longer than 255 characters");
  sieve.text(wire.version(), kVersion, word.version, "version is longer than 63 characters");
  sieve.text(wire.learner(), kName, word.learner, "learner is longer than 31 characters");
  sieve.text(wire.driver(), kName, word.driver, "driver is longer than 31 characters");
  sieve.text(wire.scenario_digest(), kDigest, word.scenario_digest, "digest is too long");
  sieve.pass(is_sha256(word.scenario_digest), "scenario digest is not 64 hexadecimal digits");
  return sieve.flaw();
}

void to_wire(const Control& word, wire::Control& wire) {
  wire.kind(static_cast<std::uint8_t>(word.kind));
  wire.ticks(word.ticks);
  wire.speed(word.speed);
  wire.robot(word.robot.value);
  wire.joystick_x(word.joystick.x());
  wire.joystick_y(word.joystick.y());
}

Flaw from_wire(const wire::Control& wire, Control& word) {
  Sieve sieve;
  word.kind = sieve.code(wire.kind(), ControlKind::SkipGoal, "unknown kind of control");
  word.ticks = wire.ticks();
  sieve.pass(word.ticks != 0, "ticks is 0, wanted at least 1");
  word.speed = sieve.number(wire.speed(), 0.0, limits::kSpeedFactor, "speed is not in 0 to 1e6");
  word.robot = {wire.robot()};
  word.joystick = sieve_joystick<WorldVec>(sieve, wire.joystick_x(), wire.joystick_y());
  return sieve.flaw();
}

void to_wire(const RunStatus& word, wire::RunStatus& wire) {
  wire.phase(static_cast<std::uint8_t>(word.phase));
  wire.tick(word.tick);
  wire.last_tick(word.last_tick);
  wire.events(word.events);
  wire.wall_s(word.wall_s);
  wire.first_tick_s(word.first_tick_s);
  wire.resent(word.resent);
  wire.rejected(word.rejected);
  wire.robots(word.robots);
  wire.present(word.present);
  wire.repeatable(word.repeatable ? 1 : 0);
}

Flaw from_wire(const wire::RunStatus& wire, RunStatus& word) {
  Sieve sieve;
  word.phase = sieve.code(wire.phase(), RunPhase::Stopped, "unknown phase");
  word.tick = sieve_tick(sieve, wire.tick());
  word.last_tick = sieve_tick(sieve, wire.last_tick());
  word.events = wire.events();
  word.wall_s = sieve.number(wire.wall_s(), 0.0, limits::kWallS, "wall time is not in 0 to 1e9 s");
  word.first_tick_s =
      sieve.number(wire.first_tick_s(), 0.0, limits::kWallS, "first tick is not in 0 to 1e9 s");
  word.resent = wire.resent();
  word.rejected = wire.rejected();
  word.robots = wire.robots();
  word.present = wire.present();
  sieve.pass(word.present <= word.robots, "more robots present than on the roster");
  word.repeatable = sieve.flag(wire.repeatable(), "repeatable is neither 0 nor 1");
  return sieve.flaw();
}

}  // namespace tacit
