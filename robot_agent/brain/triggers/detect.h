#pragma once

#include <limits>
#include <string_view>

#include "robot_agent/brain/perception/surroundings.h"

namespace tacit {

/// Fires while a thing of some classes is known, no farther than `range_m`.
struct Detect {
  static constexpr std::string_view kName = "Detect";
  ThingSet things = Thing::Mine;
  double range_m = std::numeric_limits<double>::infinity();

  [[nodiscard]] bool holds(const Surroundings& around) const {
    const Nearest& nearest = around.nearest_of(things);
    return nearest.known() && nearest.within(range_m);
  }
};

/// Fires while none is.
struct NotDetected {
  static constexpr std::string_view kName = "NotDetected";
  ThingSet things = Thing::Mine;
  double range_m = std::numeric_limits<double>::infinity();

  [[nodiscard]] bool holds(const Surroundings& around) const {
    return !Detect{things, range_m}.holds(around);
  }
};

}  // namespace tacit
