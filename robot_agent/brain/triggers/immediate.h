#pragma once

#include <string_view>

#include "robot_agent/brain/perception/surroundings.h"

namespace tacit {

/// Always fires.
struct Immediate {
  static constexpr std::string_view kName = "Immediate";

  [[nodiscard]] bool holds(const Surroundings& /*around*/) const { return true; }
};

/// Never fires.
struct Never {
  static constexpr std::string_view kName = "Never";

  [[nodiscard]] bool holds(const Surroundings& /*around*/) const { return false; }
};

}  // namespace tacit
