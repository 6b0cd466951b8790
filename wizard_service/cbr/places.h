#pragma once

#include <cmath>

#include "idl/overlay/overlay.h"

namespace tacit::cbr {

/// In metres.
[[nodiscard]] inline double distance(const MapPoint& a, const MapPoint& b) {
  const double dx = a.x_m - b.x_m;
  const double dy = a.y_m - b.y_m;
  return std::sqrt(dx * dx + dy * dy);
}

}  // namespace tacit::cbr
