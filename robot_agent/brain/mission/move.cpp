#include <algorithm>
#include <array>
#include <cmath>

#include "robot_agent/brain/mission/behaviours.h"
#include "robot_agent/brain/mission/parts.h"

namespace tacit::behaviours {
namespace {

StatePlan with_momentum(const SchemaUse& goal, const Clearance& clear, double noise_gain) {
  StatePlan state;
  state.momentum = MomentumPlan{goal, clear.gain, clear.sphere_m, clear.margin_m, noise_gain};
  return state;
}

/// The robots' places in a formation, in spacings ahead and to the left of its leader.
struct Slot {
  double ahead = 0.0;
  double left = 0.0;
};

/// Alternately left and right of the leader, the second pair farther out.
Slot in_wings(std::size_t number, double back) {
  const auto rank = static_cast<double>((number + 1) / 2);
  return {-back * rank, number % 2 == 0 ? -rank : rank};
}

Slot in_diamond(std::size_t number) {
  const auto round = static_cast<double>(number / 4);
  constexpr std::array<Slot, 4> kCorners{{{0, 0}, {-1, 1}, {-1, -1}, {-2, 0}}};
  const Slot& corner = kCorners[number % 4];
  return {corner.ahead - 3.0 * round, corner.left};
}

Slot slot_of(std::string_view formation, std::size_t number) {
  if (formation == "Column") return {-static_cast<double>(number), 0.0};
  if (formation == "Wedge") return in_wings(number, 1.0);
  if (formation == "Diamond") return in_diamond(number);
  return in_wings(number, 0.0);
}

Slot centre_of(std::string_view formation, std::size_t count) {
  Slot sum;
  for (std::size_t i = 0; i < count; ++i) {
    const Slot slot = slot_of(formation, i);
    sum.ahead += slot.ahead;
    sum.left += slot.left;
  }
  const auto n = static_cast<double>(count);
  return {sum.ahead / n, sum.left / n};
}

}  // namespace

StatePlan go_to(const Arguments& given) {
  const double gain = given.number("move_to_location_gain");
  return state_of(moving({use_of<MoveToPlace>(gain, {given.point("Goal_Location")})},
                         clearance_in(given), given.number("wander_gain")));
}

StatePlan go_to_lm(const Arguments& given) {
  const double gain = given.number("move_to_goal_gain");
  return with_momentum(use_of<MoveToPlace>(gain, {given.point("Goal_Location")}),
                       clearance_in(given), given.number("noise_gain"));
}

StatePlan move_toward(const Arguments& given) {
  const ThingSet things = given.things("Objects");
  Clearance clear = clearance_in(given);
  clear.not_robots = things;
  const MoveTo::Config config{given.number("max_sensor_range"), 0.0};
  return state_of(moving({use_of<MoveTo>(given.number("move_to_object_gain"), config, things)},
                         clear, given.number("wander_gain")));
}

StatePlan move_toward_lm(const Arguments& given) {
  const ThingSet things = given.things("Objects");
  const MoveTo::Config config{given.number("max_sensor_range"), 0.0};
  return with_momentum(use_of<MoveTo>(given.number("move_to_object_gain"), config, things),
                       clearance_in(given), given.number("wander_gain"));
}

StatePlan move_away(const Arguments& given) {
  const ThingSet things = given.things("Objects");
  Clearance clear = clearance_in(given);
  clear.not_robots = things;
  // Where the mission says nothing of the things' own sphere, the obstacles' counts.
  const bool own = given.has("avoid_objects_sphere");
  const double reach_m = own ? given.number("avoid_objects_sphere") : clear.sphere_m;
  const double margin_m = own ? given.number("avoid_objects_safety_margin") : clear.margin_m;
  return state_of(moving(
      {use_of<MoveAwayFrom>(given.number("move_away_object_gain"), {reach_m, margin_m}, things)},
      clear, given.number("wander_gain")));
}

StatePlan follow(const Arguments& given) {
  const MoveTo::Config config{given.number("max_sensor_range"), given.number("follow_distance")};
  return state_of(
      moving({use_of<MoveTo>(given.number("move_to_object_gain"), config, given.things("Objects"))},
             clearance_in(given), given.number("wander_gain")));
}

StatePlan move_ahead(const Arguments& given) {
  const MoveAhead::Config config{given.number("direction")};
  return state_of(moving({use_of<MoveAhead>(given.number("move_ahead_gain"), config)},
                         clearance_in(given), 0.0));
}

// MissionLab's Wander: gains as `curious` and `cautious` say, noise 0.8.
StatePlan wander(const Arguments& given) {
  constexpr double kNoiseGain = 0.8;
  const Clearance clear{given.number("cautious"), 1.5, 0.3, {}};
  return state_of(
      moving({use_of<MoveToFreeSpace>(given.number("curious"), {2.0})}, clear, kNoiseGain));
}

StatePlan move_in_formation(const Arguments& given, const TeamPlace& place) {
  const std::string formation = given.word("formation");
  constexpr std::array<std::string_view, 4> kFormations{"Line", "Column", "Wedge", "Diamond"};
  if (std::find(kFormations.begin(), kFormations.end(), formation) == kFormations.end()) {
    given.refuse("no formation is called " + formation + ", wanted Line, Column, Wedge or Diamond");
  }
  const double spacing_m = given.number("spacing");
  const Slot slot = slot_of(formation, place.number);
  const Slot centre = centre_of(formation, place.count);
  const WorldVec goal_m = given.point("Goal_Location");
  const KeepFormation::Config keep{goal_m, spacing_m * (slot.ahead - centre.ahead),
                                   spacing_m * (slot.left - centre.left), given.number("dead_zone"),
                                   given.number("saturation")};
  return state_of(moving({use_of<MoveToPlace>(given.number("move_to_location_gain"), {goal_m}),
                          use_of<KeepFormation>(given.number("maintain_formation_gain"), keep)},
                         clearance_in(given), 0.0));
}

// MissionLab's: the joystick with a weak avoidance of obstacles.
StatePlan telop(const Arguments& /*given*/) {
  return state_of(moving({}, {0.33, 0.5, 0.3, {}}, 0.0));
}

StatePlan about_face(const Arguments& /*given*/) { return state_of(standing({}, Turn::AboutFace)); }

StatePlan spin(const Arguments& /*given*/) { return state_of(standing({}, Turn::Scan)); }

StatePlan stop(const Arguments& /*given*/) { return state_of({}); }

}  // namespace tacit::behaviours
