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
/// disc, and leave the surroundings of the target or base, of an operation's starts and of given
/// mines free.
///
/// Throws ConfigError when the coverage cannot be reached (1000 misses in a row).
[[nodiscard]] Terrain make_terrain(const WorldConfig& config, std::uint64_t seed);

/// The point of `wall` nearest to `p`.
[[nodiscard]] WorldVec nearest_point(const Wall& wall, const WorldVec& p);

/// The distance from `p` to the nearest obstacle's surface or inner wall; negative inside an
/// obstacle, infinite on bare ground.
[[nodiscard]] double clearance_m(const Terrain& terrain, const WorldVec& p);

/// The clearance that a mine needs so that a robot can get at it from any side. [ours: room for a
/// robot between mine and surface]
[[nodiscard]] double mine_clearance_m(const WorldConfig& config);

/// The place at `share`, in [0, 1), of the way round the rectangle that lies `inset_m` inside the
/// border: from the south-west corner, counter-clockwise.
[[nodiscard]] WorldVec rim_place(const Terrain& terrain, double inset_m, double share);

}  // namespace tacit
