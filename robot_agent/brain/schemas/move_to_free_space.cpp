#include "robot_agent/brain/schemas/move_to_free_space.h"

#include <array>
#include <cmath>

namespace tacit {
namespace {

constexpr int kSectors = 12;
constexpr double kSectorRad = 2.0 * kPi / kSectors;

/// The sector that a direction lies in; sector 0 has the heading in its middle.
int sector_of(double bearing_rad) {
  const int sector = static_cast<int>(std::floor(bearing_rad / kSectorRad + 0.5));
  return (sector % kSectors + kSectors) % kSectors;
}

}  // namespace

BodyVec MoveToFreeSpace::push(const Surroundings& around) {
  std::array<bool, kSectors> barred{};
  for (const SeenObstacle& obstacle : around.obstacles) {
    if (obstacle.offset_m.norm() - obstacle.radius_m >= config_.horizon_m) continue;
    const double bearing_rad = arc_tangent(obstacle.offset_m.y(), obstacle.offset_m.x());
    barred[static_cast<std::size_t>(sector_of(bearing_rad))] = true;
  }
  for (int k = 0; k <= kSectors / 2; ++k) {
    for (const int side : {1, -1}) {
      const int sector = ((side * k) % kSectors + kSectors) % kSectors;
      if (barred[static_cast<std::size_t>(sector)]) continue;
      const SinCos way = sin_cos(side * k * kSectorRad);
      return (1.0 - k / 6.0) * BodyVec{way.cos, way.sin};
    }
  }
  return {};
}

}  // namespace tacit
