#pragma once

#include <string_view>

#include "robot_agent/brain/perception/surroundings.h"

namespace tacit {

/// Fires while a thing of a class is no farther than `range_m`, centre to centre.
struct Near {
  static constexpr std::string_view kName = "Near";
  Thing thing = Thing::Mine;
  double range_m = 0.0;

  [[nodiscard]] bool holds(const Surroundings& around) const {
    return around.nearest_of(thing).within(range_m);
  }
};

/// Fires while every thing of a class is farther, also when none is known.
struct AwayFrom {
  static constexpr std::string_view kName = "AwayFrom";
  Thing thing = Thing::Mine;
  double range_m = 0.0;

  [[nodiscard]] bool holds(const Surroundings& around) const {
    return !around.nearest_of(thing).within(range_m);
  }
};

}  // namespace tacit
