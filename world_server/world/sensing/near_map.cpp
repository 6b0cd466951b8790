#include "world_server/world/sensing/near_map.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "idl/types/config_error.h"

namespace tacit {
namespace {

constexpr double kEdge_m = 5.0;
constexpr double kMaxCellsPerSide = 256.0;

double edge_for(const Terrain& terrain) {
  return std::max(kEdge_m, std::max(terrain.width_m, terrain.height_m) / kMaxCellsPerSide);
}

std::size_t cells_over(double length_m, double edge_m) {
  return static_cast<std::size_t>(std::max(1.0, std::ceil(length_m / edge_m)));
}

std::size_t index_along(double x, double edge_m, std::size_t count) {
  const double i = std::floor(x / edge_m);
  return i <= 0.0 ? 0 : std::min(count - 1, static_cast<std::size_t>(i));
}

}  // namespace

NearMap::NearMap(const Terrain& terrain, double reach_m)
    : edge_m_(edge_for(terrain)),
      columns_(cells_over(terrain.width_m, edge_m_)),
      rows_(cells_over(terrain.height_m, edge_m_)),
      bare_(terrain.obstacles.empty() && terrain.walls.empty()) {
  constexpr std::size_t kMost = std::numeric_limits<std::uint16_t>::max();
  if (terrain.obstacles.size() > kMost || terrain.walls.size() > kMost) {
    throw ConfigError("the area holds more than 65535 obstacles or walls; wanted fewer");
  }
  const double slack_m = reach_m + edge_m_ * std::sqrt(0.5);
  for (std::size_t row = 0; row < rows_; ++row) {
    for (std::size_t column = 0; column < columns_; ++column) {
      const WorldVec middle{(static_cast<double>(column) + 0.5) * edge_m_,
                            (static_cast<double>(row) + 0.5) * edge_m_};
      obstacles_.first.push_back(static_cast<std::uint32_t>(obstacles_.items.size()));
      for (std::size_t i = 0; i < terrain.obstacles.size(); ++i) {
        const Disc& disc = terrain.obstacles[i];
        if ((disc.centre_m - middle).norm() - disc.radius_m <= slack_m) {
          obstacles_.items.push_back(static_cast<std::uint16_t>(i));
        }
      }
      walls_.first.push_back(static_cast<std::uint32_t>(walls_.items.size()));
      for (std::size_t i = 0; i < terrain.walls.size(); ++i) {
        if ((nearest_point(terrain.walls[i], middle) - middle).norm() <= slack_m) {
          walls_.items.push_back(static_cast<std::uint16_t>(i));
        }
      }
    }
  }
  obstacles_.first.push_back(static_cast<std::uint32_t>(obstacles_.items.size()));
  walls_.first.push_back(static_cast<std::uint32_t>(walls_.items.size()));
}

std::span<const std::uint16_t> NearMap::Lists::at(std::size_t cell) const {
  return {items.data() + first[cell], items.data() + first[cell + 1]};
}

std::size_t NearMap::cell(const WorldVec& p) const {
  return index_along(p.y(), edge_m_, rows_) * columns_ + index_along(p.x(), edge_m_, columns_);
}

NearMap::Near NearMap::near(const WorldVec& p) const {
  if (bare_) {
    return {};
  }
  const std::size_t i = cell(p);
  return {obstacles_.at(i), walls_.at(i)};
}

}  // namespace tacit
