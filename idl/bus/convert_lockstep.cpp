#include "idl/bus/convert_lockstep.h"

#include <array>
#include <cassert>

#include "idl/bus/sieve_words.h"
#include "idl/wire/lockstep.h"

namespace tacit {
namespace {

void to_wire(const BodyVec& offset_m, double radius_m, wire::Disc& disc) {
  disc.x_m(offset_m.x());
  disc.y_m(offset_m.y());
  disc.radius_m(radius_m);
}

BodyVec offset_of(Sieve& sieve, const wire::Disc& disc) {
  return sieve_vec<BodyVec>(sieve, disc.x_m(), disc.y_m(), limits::kPositionM,
                            "offset is no position within 1e6 m");
}

double radius_of(Sieve& sieve, const wire::Disc& disc) {
  return sieve.number(disc.radius_m(), 0.0, limits::kRadiusM, "radius is not in 0 to 1e4 m");
}

void sightings_to_wire(const Percept& word, wire::Percept& wire) {
  const std::size_t count = word.sightings.size();
  assert(count <= Percept::kMaxSightings);
  wire.sighting_count(static_cast<std::uint16_t>(count));
  for (std::size_t i = 0; i < count; ++i) {
    const Sighting& seen = word.sightings[i];
    to_wire(seen.offset_m, seen.radius_m, wire.sightings()[i]);
    wire.sighting_kind()[i] = static_cast<std::uint8_t>(seen.kind);
    wire.sighting_colour()[i] = static_cast<std::uint8_t>(seen.colour);
  }
}

void obstacles_to_wire(const Percept& word, wire::Percept& wire) {
  const std::size_t count = word.obstacles.size();
  assert(count <= Percept::kMaxObstacles);
  wire.obstacle_count(static_cast<std::uint16_t>(count));
  for (std::size_t i = 0; i < count; ++i) {
    to_wire(word.obstacles[i].offset_m, word.obstacles[i].radius_m, wire.obstacles()[i]);
  }
}

void sightings_from_wire(Sieve& sieve, const wire::Percept& wire, Percept& word) {
  word.sightings.resize(sieve.count(wire.sighting_count(), Percept::kMaxSightings,
                                    "more sightings than a percept holds"));
  for (std::size_t i = 0; i < word.sightings.size(); ++i) {
    Sighting& seen = word.sightings[i];
    seen.kind = sieve.code(wire.sighting_kind()[i], Kind::Object, "unknown kind of sighting");
    seen.colour = sieve.code(wire.sighting_colour()[i], Colour::Grey, "unknown colour");
    seen.offset_m = offset_of(sieve, wire.sightings()[i]);
    seen.radius_m = radius_of(sieve, wire.sightings()[i]);
  }
}

void obstacles_from_wire(Sieve& sieve, const wire::Percept& wire, Percept& word) {
  word.obstacles.resize(sieve.count(wire.obstacle_count(), Percept::kMaxObstacles,
                                    "more obstacles than a percept holds"));
  for (std::size_t i = 0; i < word.obstacles.size(); ++i) {
    word.obstacles[i].offset_m = offset_of(sieve, wire.obstacles()[i]);
    word.obstacles[i].radius_m = radius_of(sieve, wire.obstacles()[i]);
  }
}

/// The bit of each deed on the wire.
struct DeedBit {
  bool Deeds::*deed;
  unsigned bit;
};
constexpr std::array<DeedBit, 8> kDeedBits{{{&Deeds::picked_up, 1},
                                            {&Deeds::stored, 2},
                                            {&Deeds::dropped, 4},
                                            {&Deeds::intercepted, 8},
                                            {&Deeds::revived, 16},
                                            {&Deeds::marked, 32},
                                            {&Deeds::signalled, 64},
                                            {&Deeds::alerted, 128}}};

std::uint8_t bits_of(const Deeds& deeds) {
  unsigned bits = 0;
  for (const DeedBit& each : kDeedBits) bits |= deeds.*each.deed ? each.bit : 0U;
  return static_cast<std::uint8_t>(bits);
}

Deeds deeds_of(unsigned bits) {
  Deeds deeds;
  for (const DeedBit& each : kDeedBits) deeds.*each.deed = (bits & each.bit) != 0;
  return deeds;
}

void doorways_to_wire(const Percept& word, wire::Percept& wire) {
  const std::size_t count = word.doorways.size();
  assert(count <= Percept::kMaxDoorways);
  wire.doorway_count(static_cast<std::uint16_t>(count));
  for (std::size_t i = 0; i < count; ++i) {
    const SeenDoorway& seen = word.doorways[i];
    wire.doorways()[i].x_m(seen.offset_m.x());
    wire.doorways()[i].y_m(seen.offset_m.y());
    wire.doorways()[i].jamb_x_m(seen.jamb_m.x());
    wire.doorways()[i].jamb_y_m(seen.jamb_m.y());
    wire.doorway_marked()[i] = seen.marked ? 1 : 0;
  }
}

void doorways_from_wire(Sieve& sieve, const wire::Percept& wire, Percept& word) {
  word.doorways.resize(sieve.count(wire.doorway_count(), Percept::kMaxDoorways,
                                   "more doorways than a percept holds"));
  for (std::size_t i = 0; i < word.doorways.size(); ++i) {
    const wire::Doorway& seen = wire.doorways()[i];
    word.doorways[i].offset_m = sieve_vec<BodyVec>(
        sieve, seen.x_m(), seen.y_m(), limits::kPositionM, "doorway is not within 1e6 m");
    word.doorways[i].jamb_m = sieve_vec<BodyVec>(sieve, seen.jamb_x_m(), seen.jamb_y_m(),
                                                 limits::kPositionM, "jamb is not within 1e6 m");
    word.doorways[i].marked = sieve.flag(wire.doorway_marked()[i], "marked is neither 0 nor 1");
  }
}

void hallway_to_wire(const Percept& word, wire::Percept& wire) {
  wire.in_hallway(word.hallway ? 1 : 0);
  if (!word.hallway) return;
  wire.hallway_x_m(word.hallway->offset_m.x());
  wire.hallway_y_m(word.hallway->offset_m.y());
  wire.hallway_along_x(word.hallway->along.x());
  wire.hallway_along_y(word.hallway->along.y());
  wire.hallway_ahead_m(word.hallway->ahead_m);
  wire.hallway_behind_m(word.hallway->behind_m);
  wire.hallway_width_m(word.hallway->width_m);
}

void hallway_from_wire(Sieve& sieve, const wire::Percept& wire, Percept& word) {
  word.hallway.reset();
  if (!sieve.flag(wire.in_hallway(), "in_hallway is neither 0 nor 1")) return;
  const auto length = [&sieve](double value_m) {
    return sieve.number(value_m, 0.0, limits::kPositionM, "hallway is not 0 to 1e6 m");
  };
  SeenHallway& hallway = word.hallway.emplace();
  hallway.offset_m = sieve_vec<BodyVec>(sieve, wire.hallway_x_m(), wire.hallway_y_m(),
                                        limits::kPositionM, "hallway is not within 1e6 m");
  const Heading along = sieve_heading(sieve, wire.hallway_along_x(), wire.hallway_along_y());
  hallway.along = {along.cos, along.sin};
  hallway.ahead_m = length(wire.hallway_ahead_m());
  hallway.behind_m = length(wire.hallway_behind_m());
  hallway.width_m = length(wire.hallway_width_m());
}

void heard_to_wire(const Percept& word, wire::Percept& wire) {
  const std::size_t count = word.heard.size();
  assert(count <= Percept::kMaxHeard);
  wire.heard_count(static_cast<std::uint8_t>(count));
  for (std::size_t i = 0; i < count; ++i) word_to_wire(word.heard[i], wire.heard()[i]);
}

void heard_from_wire(Sieve& sieve, const wire::Percept& wire, Percept& word) {
  word.heard.clear();
  const std::size_t count =
      sieve.count(wire.heard_count(), Percept::kMaxHeard, "more words heard than a percept holds");
  for (std::size_t i = 0; i < count; ++i) {
    word.heard.push_back(sieve_word(sieve, wire.heard()[i]));
  }
}

void operated_to_wire(const OperatorInput& word, wire::Percept& wire) {
  wire.teleoperated(word.teleoperated ? 1 : 0);
  wire.joystick_x(word.joystick.x());
  wire.joystick_y(word.joystick.y());
  wire.proceed(word.proceed ? 1 : 0);
  wire.skip_goal(word.skip_goal ? 1 : 0);
}

void operated_from_wire(Sieve& sieve, const wire::Percept& wire, OperatorInput& word) {
  word.teleoperated = sieve.flag(wire.teleoperated(), "teleoperated is neither 0 nor 1");
  word.joystick = sieve_joystick<BodyVec>(sieve, wire.joystick_x(), wire.joystick_y());
  word.proceed = sieve.flag(wire.proceed(), "proceed is neither 0 nor 1");
  word.skip_goal = sieve.flag(wire.skip_goal(), "skip_goal is neither 0 nor 1");
}

/// The colour that a command is about: 0 for any.
std::uint8_t code_of(const std::optional<Colour>& about) {
  return about ? static_cast<std::uint8_t>(static_cast<unsigned>(*about) + 1U) : std::uint8_t{0};
}

std::optional<Colour> about_of(Sieve& sieve, std::uint8_t code) {
  if (code == 0) return std::nullopt;
  return sieve.code(static_cast<std::uint8_t>(code - 1U), Colour::Grey, "unknown colour");
}

}  // namespace

void to_wire(const Percept& word, wire::Percept& wire) {
  wire.robot(word.robot.value);
  wire.tick(word.tick);
  wire.odometry_x_m(word.odometry.position_m.x());
  wire.odometry_y_m(word.odometry.position_m.y());
  wire.odometry_cos(word.odometry.heading.cos);
  wire.odometry_sin(word.odometry.heading.sin);
  wire.velocity_x_mps(word.velocity_mps.x());
  wire.velocity_y_mps(word.velocity_mps.y());
  wire.touching(word.touching ? 1 : 0);
  wire.able(word.able ? 1 : 0);
  wire.holding(word.holding ? 1 : 0);
  wire.held(static_cast<std::uint8_t>(word.held));
  wire.deeds(bits_of(word.deeds));
  wire.tested(static_cast<std::uint8_t>(word.deeds.tested));
  wire.site(static_cast<std::uint8_t>(word.site));
  wire.spare().fill(0);
  sightings_to_wire(word, wire);
  obstacles_to_wire(word, wire);
  doorways_to_wire(word, wire);
  hallway_to_wire(word, wire);
  heard_to_wire(word, wire);
  operated_to_wire(word.operated, wire);
}

Flaw from_wire(const wire::Percept& wire, Percept& word) {
  Sieve sieve;
  word.robot = sieve_robot(sieve, wire.robot());
  word.tick = sieve_tick(sieve, wire.tick());
  word.odometry.position_m =
      sieve_vec<OdometryVec>(sieve, wire.odometry_x_m(), wire.odometry_y_m(), limits::kOdometryM,
                             "odometry is no position within 1e9 m");
  word.odometry.heading = sieve_heading(sieve, wire.odometry_cos(), wire.odometry_sin());
  word.velocity_mps = sieve_vec<BodyVec>(sieve, wire.velocity_x_mps(), wire.velocity_y_mps(),
                                         limits::kSpeedMps, "velocity is not within 1e4 m/s");
  word.touching = sieve.flag(wire.touching(), "touching is neither 0 nor 1");
  word.able = sieve.flag(wire.able(), "able is neither 0 nor 1");
  word.holding = sieve.flag(wire.holding(), "holding is neither 0 nor 1");
  word.held = sieve.code(wire.held(), Colour::Grey, "unknown colour held");
  word.deeds = deeds_of(wire.deeds());
  word.deeds.tested = sieve.code(wire.tested(), Finding::Dangerous, "unknown finding");
  word.site = sieve.code(wire.site(), Site::Hallway, "unknown site");
  sightings_from_wire(sieve, wire, word);
  obstacles_from_wire(sieve, wire, word);
  doorways_from_wire(sieve, wire, word);
  hallway_from_wire(sieve, wire, word);
  heard_from_wire(sieve, wire, word);
  operated_from_wire(sieve, wire, word.operated);
  return sieve.flaw();
}

void to_wire(const Command& word, wire::Command& wire) {
  wire.robot(word.robot.value);
  wire.tick(word.tick);
  wire.velocity_x_mps(word.velocity_mps.x());
  wire.velocity_y_mps(word.velocity_mps.y());
  wire.turn_radps(word.turn_radps);
  wire.act(static_cast<std::uint8_t>(word.act));
  wire.about(code_of(word.about));
  word_to_wire(word.word, wire.word());
  wire.spare().fill(0);
}

Flaw from_wire(const wire::Command& wire, Command& word) {
  Sieve sieve;
  word.robot = sieve_robot(sieve, wire.robot());
  word.tick = sieve_tick(sieve, wire.tick());
  word.velocity_mps = sieve_vec<BodyVec>(sieve, wire.velocity_x_mps(), wire.velocity_y_mps(),
                                         limits::kSpeedMps, "velocity is not within 1e4 m/s");
  word.turn_radps = sieve.number(wire.turn_radps(), -limits::kTurnRadps, limits::kTurnRadps,
                                 "turn rate is not within 1e4 rad/s");
  word.act = sieve.code(wire.act(), Act::FinishAll, "unknown act");
  word.about = about_of(sieve, wire.about());
  word.word = sieve_word(sieve, wire.word());
  return sieve.flaw();
}

}  // namespace tacit
