#pragma once

#include <string_view>

#include "robot_agent/brain/perception/surroundings.h"

namespace tacit {

/// Fires while the robot carries a mine.
struct Holding {
  static constexpr std::string_view kName = "Holding";

  [[nodiscard]] bool holds(const Surroundings& around) const { return around.holding; }
};

/// Fires while it carries none.
struct NotHolding {
  static constexpr std::string_view kName = "NotHolding";

  [[nodiscard]] bool holds(const Surroundings& around) const { return !around.holding; }
};

}  // namespace tacit
