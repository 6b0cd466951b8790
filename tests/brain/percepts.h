#pragma once

#include <cmath>
#include <vector>

#include "idl/types/percept.h"
#include "idl/types/random.h"
#include "robot_agent/brain/perception/surroundings.h"

namespace tacit::testing {

inline Seen seen(double x, double y) { return {{x, y}, std::sqrt(x * x + y * y), true}; }

inline Sighting target(double x, double y) { return {Kind::Target, Colour::White, {x, y}, 1.0}; }
inline Sighting teammate(double x, double y) { return {Kind::Teammate, Colour::Blue, {x, y}, 0.2}; }
inline Sighting disabled(double x, double y) {
  return {Kind::Teammate, Colour::Yellow, {x, y}, 0.2};
}
inline Sighting enemy(double x, double y) { return {Kind::Enemy, Colour::Red, {x, y}, 0.2}; }

inline Sighting mine(double x, double y) { return {Kind::Mine, Colour::Orange, {x, y}, 0.25}; }
inline Sighting base(double x, double y) { return {Kind::Base, Colour::Purple, {x, y}, 0.5}; }

inline Percept percept(Tick tick, std::vector<Sighting> sightings) {
  Percept percept;
  percept.robot = RobotId{1};
  percept.tick = tick;
  percept.sightings = std::move(sightings);
  return percept;
}

/// What is seen at `tick` of a busy scene in which all but the obstacles moves steadily; another
/// scene begins every 20 ticks.
inline Percept busy_percept(Tick tick, std::uint64_t seed) {
  Stream chance(seed, "busy percept", tick / 20);
  const auto time = static_cast<double>(tick % 20);
  const auto place = [&chance](double reach) {
    return OdometryVec{chance.uniform(-reach, reach), chance.uniform(-reach, reach)};
  };
  const auto moving = [&](double step) {
    const OdometryVec start = place(60.0);
    return start + time * place(step);
  };
  Percept percept = testing::percept(tick, {});
  percept.odometry = {moving(0.3), Heading::from_rad(chance.uniform(-3.0, 3.0) + 0.01 * time)};
  const auto body = [&](const OdometryVec& at) {
    return to_body(percept.odometry.heading, at - percept.odometry.position_m);
  };
  percept.sightings.push_back({Kind::Target, Colour::White, body(place(60.0)), 1.0});
  for (int i = 0; i < 5; ++i) {
    percept.sightings.push_back({Kind::Teammate, Colour::Blue, body(moving(0.2)), 0.2});
  }
  for (int i = 0; i < 12; ++i) {
    percept.sightings.push_back({Kind::Enemy, Colour::Red, body(moving(0.1)), 0.2});
  }
  for (int i = 0; i < 4; ++i) {
    percept.obstacles.push_back({BodyVec(place(4.0).xy), 1.0});
  }
  return percept;
}

/// The same of a foraging team: scenes of 20 ticks in which things come, go and move, with deeds,
/// and with the robot disabled in one tick out of eight.
inline Percept busy_forage_percept(Tick tick, std::uint64_t seed) {
  Percept percept = busy_percept(tick, seed);
  percept.sightings.clear();
  Stream scene(seed, "forage scene", tick / 20);
  Stream chance(seed, "forage tick", tick);
  const auto place = [&scene](double reach) {
    return BodyVec{scene.uniform(-reach, reach), scene.uniform(-reach, reach)};
  };
  const BodyVec enemy_m = place(8.0);
  const auto time = static_cast<double>(tick % 20);
  if (scene.below(3) > 0) {
    percept.sightings.push_back(enemy(enemy_m.x() + 0.1 * time, enemy_m.y() - 0.2 * time));
  }
  if (scene.below(2) > 0) percept.sightings.push_back(disabled(place(8.0).x(), place(8.0).y()));
  if (scene.below(2) > 0) percept.sightings.push_back(base(place(2.0).x(), place(2.0).y()));
  for (std::uint64_t i = scene.below(4); i > 0; --i) {
    percept.sightings.push_back(mine(place(1.0).x(), place(1.0).y()));
    percept.sightings.push_back(teammate(place(2.0).x(), place(2.0).y()));
  }
  percept.holding = scene.below(2) > 0;
  percept.able = chance.below(8) > 0;
  percept.deeds.stored = chance.below(10) == 0;
  percept.deeds.revived = chance.below(10) == 0;
  return percept;
}

}  // namespace tacit::testing
