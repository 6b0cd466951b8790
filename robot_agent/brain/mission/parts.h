#pragma once

#include <string_view>
#include <utility>
#include <vector>

#include "robot_agent/brain/fsa/automaton_plan.h"
#include "robot_agent/brain/mission/arguments.h"

namespace tacit {

/// How a moving behaviour keeps clear of what is in its way.
struct Clearance {
  double gain = 1.0;
  double sphere_m = 1.2;
  double margin_m = 0.3;
  ThingSet not_robots{};  ///< Classes of robots that it goes to or after, so does not avoid.
};

/// As the mission gives it, the gain by the name `gain`, which differs from behaviour to behaviour.
[[nodiscard]] inline Clearance clearance_in(const Arguments& given,
                                            std::string_view gain = "avoid_obstacle_gain") {
  return {given.number(gain),
          given.number("avoid_obstacle_sphere"),
          given.number("avoid_obstacle_safety_margin"),
          {}};
}

/// How long a probe touches an object before it says what it is [MissionLab].
inline constexpr Tick kProbeTicks = 10;

/// A use of schema `S`.
template <class S>
[[nodiscard]] SchemaUse use_of(double gain, const typename S::Config& config,
                               ThingSet things = {}) {
  return {std::string(S::kName), gain, things, config};
}

/// `schemas` with what every moving behaviour has beside: AvoidObstacles and AvoidRobots, Noise
/// with `wander_gain`, and the operator's joystick.
[[nodiscard]] inline ActivityPlan moving(std::vector<SchemaUse> schemas, const Clearance& clearance,
                                         double wander_gain) {
  const double margin_m = clearance.margin_m;
  const double sphere_m = clearance.sphere_m;
  schemas.push_back(use_of<AvoidObstacles>(clearance.gain, {sphere_m, margin_m}));
  schemas.push_back(use_of<AvoidRobots>(
      clearance.gain, {sphere_m, margin_m, !clearance.not_robots.has(Thing::Friend),
                       !clearance.not_robots.has(Thing::Enemy)}));
  schemas.push_back(use_of<Noise>(wander_gain, {10}));
  schemas.push_back({std::string(Telop::kName), 1.0, {}, {}});
  return {std::move(schemas), {}, Turn::None, {}};
}

/// An activity that stands still and does `deed`.
[[nodiscard]] inline ActivityPlan standing(const Deed& deed, Turn turn = Turn::None) {
  return {{}, deed, turn, {}};
}

[[nodiscard]] inline StatePlan state_of(ActivityPlan activity) {
  StatePlan state;
  state.activity = std::move(activity);
  return state;
}

}  // namespace tacit
