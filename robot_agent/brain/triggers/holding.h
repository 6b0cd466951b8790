#pragma once

#include <optional>
#include <string_view>

#include "robot_agent/brain/perception/surroundings.h"

namespace tacit {

/// Fires while the robot carries a mine or an object, of one colour when that is given.
struct Holding {
  static constexpr std::string_view kName = "Holding";
  std::optional<Colour> colour = std::nullopt;

  [[nodiscard]] bool holds(const Surroundings& around) const {
    return around.holding && (!colour || around.premises.held == *colour);
  }
};

/// Fires while it carries none.
struct NotHolding {
  static constexpr std::string_view kName = "NotHolding";
  std::optional<Colour> colour = std::nullopt;

  [[nodiscard]] bool holds(const Surroundings& around) const {
    return !Holding{colour}.holds(around);
  }
};

}  // namespace tacit
