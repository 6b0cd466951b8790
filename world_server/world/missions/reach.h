#pragma once

#include "idl/types/frames.h"
#include "world_server/world/sensing/line_of_sight.h"

namespace tacit {

/// From where and how far a robot gets at things that no wall is in front of.
struct Reach {
  WorldVec from_m;
  double reach_m = 0.0;
  const LineOfSight* sight = nullptr;  ///< It looks from `from_m`.

  /// Whether a thing is in reach whose rim is `radius_m` from its middle.
  [[nodiscard]] bool holds(const WorldVec& middle_m, double radius_m = 0.0) const {
    const WorldVec offset = middle_m - from_m;
    const double most_m = reach_m + radius_m;
    return offset.squared_norm() <= most_m * most_m && sight->clear(offset);
  }
};

}  // namespace tacit
