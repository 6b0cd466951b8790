#pragma once

#include <string_view>

#include "robot_agent/brain/fsa/entry.h"
#include "robot_agent/brain/perception/surroundings.h"

namespace tacit {

/// Fires when the operator gives the word to go on.
struct Proceed {
  static constexpr std::string_view kName = "Proceed";

  [[nodiscard]] bool holds(const Surroundings& around) const {
    return around.premises.operated.proceed;
  }
};

/// Fires when the operator lets the robot leave out its goal.
struct SkipGoal {
  static constexpr std::string_view kName = "SkipGoal";

  [[nodiscard]] bool holds(const Surroundings& around) const {
    return around.premises.operated.skip_goal;
  }
};

/// Fires when the operator gives the word to go on with the joystick let go.
struct TelopComplete {
  static constexpr std::string_view kName = "TelopComplete";

  [[nodiscard]] bool holds(const Surroundings& around) const {
    const OperatorInput& operated = around.premises.operated;
    return operated.proceed && !operated.teleoperated;
  }
};

}  // namespace tacit
