#pragma once

#include <string_view>

#include "robot_agent/brain/perception/surroundings.h"
#include "robot_agent/brain/schemas/keep_formation.h"

namespace tacit {

/// Fires while the robot is no farther than `tolerance_m` from a place on the map.
struct AtGoal {
  static constexpr std::string_view kName = "AtGoal";
  WorldVec goal_m;
  double tolerance_m = 0.5;

  [[nodiscard]] bool holds(const Surroundings& around) const {
    return (goal_m - around.premises.pose.position_m).norm() <= tolerance_m;
  }
};

/// Fires also when the operator lets the robot leave out its goal.
struct AtOrSkipGoal {
  static constexpr std::string_view kName = "AtOrSkipGoal";
  WorldVec goal_m;
  double tolerance_m = 0.5;

  [[nodiscard]] bool holds(const Surroundings& around) const {
    return around.premises.operated.skip_goal || AtGoal{goal_m, tolerance_m}.holds(around);
  }
};

/// Fires while the centre of the robot and the teammates in sight is so near to a place.
struct AtGoalInFormation {
  static constexpr std::string_view kName = "AtGoalInFormation";
  WorldVec goal_m;
  double tolerance_m = 0.5;

  [[nodiscard]] bool holds(const Surroundings& around) const {
    const Premises& here = around.premises;
    const BodyVec to_goal_m = to_body(here.pose.heading, goal_m - here.pose.position_m);
    return (to_goal_m - unit_centre_m(here)).norm() <= tolerance_m;
  }
};

}  // namespace tacit
