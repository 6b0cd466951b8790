#include "world_server/world/start.h"

#include <algorithm>
#include <string>

#include "idl/types/config_error.h"
#include "idl/types/random.h"

namespace tacit {
namespace {

bool free_of_terrain(const WorldVec& p, double radius_m, const Terrain& terrain) {
  const bool clear_of_discs = std::none_of(
      terrain.obstacles.begin(), terrain.obstacles.end(),
      [&](const Disc& disc) { return (disc.centre_m - p).norm() < disc.radius_m + radius_m; });
  return clear_of_discs &&
         std::none_of(terrain.walls.begin(), terrain.walls.end(), [&](const Wall& wall) {
           return (nearest_point(wall, p) - p).norm() < radius_m;
         });
}

bool free_of_robots(const WorldVec& p, double radius_m, const std::vector<WorldPose>& robots) {
  return std::none_of(robots.begin(), robots.end(), [&](const WorldPose& other) {
    return (other.position_m - p).norm() < 2.0 * radius_m;
  });
}

WorldPose on_ring(const WorldConfig& config, std::size_t index) {
  const double share = static_cast<double>(index) / static_cast<double>(config.robots.count);
  const Heading outward = Heading::from_rad(2.0 * kPi * share);
  const FocusPoint point = focus(config);
  const WorldVec centre{point.x_m, point.y_m};
  return {centre + config.robots.ring_radius_m * WorldVec{outward.cos, outward.sin}, outward};
}

WorldPose anywhere(const WorldConfig& config, Stream& chance) {
  const double r = config.robots.radius_m;
  const double x = chance.uniform(r, config.area.width_m - r);
  const double y = chance.uniform(r, config.area.height_m - r);
  return {{x, y}, Heading::from_rad(chance.uniform(-kPi, kPi))};
}

}  // namespace

std::vector<WorldPose> start_poses(const WorldConfig& config, const Terrain& terrain,
                                   std::uint64_t seed) {
  const bool ring = config.robots.start == "ring";
  const int tries = ring ? 1 : 1000;
  Stream chance(seed, "start places");
  std::vector<WorldPose> poses;
  for (std::size_t i = 0; i < static_cast<std::size_t>(config.robots.count); ++i) {
    bool placed = false;
    for (int attempt = 0; attempt < tries && !placed; ++attempt) {
      const WorldPose pose = ring ? on_ring(config, i) : anywhere(config, chance);
      placed = free_of_terrain(pose.position_m, config.robots.radius_m, terrain) &&
               free_of_robots(pose.position_m, config.robots.radius_m, poses);
      if (placed) {
        poses.push_back(pose);
      }
    }
    if (!placed) {
      throw ConfigError("[robots] count = " + std::to_string(config.robots.count) +
                        ": no room for robot " + std::to_string(i + 1) +
                        "; wanted fewer or smaller robots, a wider ring_radius_m or a larger "
                        "[obstacles] keep_free_m");
    }
  }
  return poses;
}

}  // namespace tacit
