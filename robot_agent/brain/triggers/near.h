#pragma once

#include <cstdint>
#include <string_view>

#include "robot_agent/brain/perception/surroundings.h"

namespace tacit {

/// From the robot's centre to which part of a thing.
enum class Measured : std::uint8_t { ToCentre, ToSurface };

/// Fires while a thing of some classes is no farther than `range_m`.
struct Near {
  static constexpr std::string_view kName = "Near";
  ThingSet things = Thing::Mine;
  double range_m = 0.0;
  Measured measured = Measured::ToCentre;

  [[nodiscard]] bool holds(const Surroundings& around) const {
    const Nearest& nearest = around.nearest_of(things);
    return measured == Measured::ToCentre ? nearest.within(range_m)
                                          : nearest.surface_within(range_m);
  }
};

/// Fires while every thing of some classes is farther, also when none is known.
struct AwayFrom {
  static constexpr std::string_view kName = "AwayFrom";
  ThingSet things = Thing::Mine;
  double range_m = 0.0;
  Measured measured = Measured::ToCentre;

  [[nodiscard]] bool holds(const Surroundings& around) const {
    return !Near{things, range_m, measured}.holds(around);
  }
};

}  // namespace tacit
