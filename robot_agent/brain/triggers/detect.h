#pragma once

#include <string_view>

#include "robot_agent/brain/perception/surroundings.h"

namespace tacit {

/// Fires while a thing of a class is known.
struct Detect {
  static constexpr std::string_view kName = "Detect";
  Thing thing = Thing::Mine;

  [[nodiscard]] bool holds(const Surroundings& around) const {
    return around.nearest_of(thing).known();
  }
};

/// Fires while none is.
struct NotDetected {
  static constexpr std::string_view kName = "NotDetected";
  Thing thing = Thing::Mine;

  [[nodiscard]] bool holds(const Surroundings& around) const {
    return !around.nearest_of(thing).known();
  }
};

}  // namespace tacit
