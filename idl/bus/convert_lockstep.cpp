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
    seen.kind = sieve.code(wire.sighting_kind()[i], Kind::Base, "unknown kind of sighting");
    seen.colour = sieve.code(wire.sighting_colour()[i], Colour::Purple, "unknown colour");
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
constexpr std::array<DeedBit, 5> kDeedBits{{{&Deeds::picked_up, 1},
                                            {&Deeds::stored, 2},
                                            {&Deeds::dropped, 4},
                                            {&Deeds::intercepted, 8},
                                            {&Deeds::revived, 16}}};

std::uint8_t bits_of(const Deeds& deeds) {
  unsigned bits = 0;
  for (const DeedBit& each : kDeedBits) bits |= deeds.*each.deed ? each.bit : 0U;
  return static_cast<std::uint8_t>(bits);
}

Deeds deeds_of(Sieve& sieve, unsigned bits) {
  Deeds deeds;
  if (!sieve.pass(bits < 32, "unknown deed")) return deeds;
  for (const DeedBit& each : kDeedBits) deeds.*each.deed = (bits & each.bit) != 0;
  return deeds;
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
  wire.deeds(bits_of(word.deeds));
  wire.spare().fill(0);
  sightings_to_wire(word, wire);
  obstacles_to_wire(word, wire);
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
  word.deeds = deeds_of(sieve, wire.deeds());
  sightings_from_wire(sieve, wire, word);
  obstacles_from_wire(sieve, wire, word);
  return sieve.flaw();
}

void to_wire(const Command& word, wire::Command& wire) {
  wire.robot(word.robot.value);
  wire.tick(word.tick);
  wire.velocity_x_mps(word.velocity_mps.x());
  wire.velocity_y_mps(word.velocity_mps.y());
  wire.turn_radps(word.turn_radps);
  wire.act(static_cast<std::uint8_t>(word.act));
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
  word.act = sieve.code(wire.act(), Act::Aid, "unknown act");
  return sieve.flaw();
}

}  // namespace tacit
