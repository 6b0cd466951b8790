#pragma once

#include <cstdint>
#include <vector>

#include "idl/types/frames.h"
#include "world_server/world/world_config.h"

namespace tacit {

/// A round obstacle.
struct Disc {
  WorldVec centre_m;
  double radius_m = 0.0;
};

/// A straight wall without thickness.
struct Wall {
  WorldVec from_m;
  WorldVec to_m;
};

/// What does not move.
struct Terrain {
  double width_m = 0.0;
  double height_m = 0.0;
  bool border_walls = true;
  std::vector<Disc> obstacles;
  std::vector<Wall> walls;  ///< Without the border.
};

/// Lays out the area: the given walls and discs, then random discs until the wanted share of the
/// area is covered. Random discs lie whole inside the area, do not overlap one another or a given
/// disc, and leave the target's surroundings free.
///
/// Throws ConfigError when the coverage cannot be reached (1000 misses in a row).
[[nodiscard]] Terrain make_terrain(const WorldConfig& config, std::uint64_t seed);

/// The point of `wall` nearest to `p`.
[[nodiscard]] WorldVec nearest_point(const Wall& wall, const WorldVec& p);

}  // namespace tacit
