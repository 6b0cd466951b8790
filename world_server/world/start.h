#pragma once

#include <vector>

#include "idl/types/frames.h"
#include "world_server/world/terrain.h"
#include "world_server/world/world_config.h"

namespace tacit {

/// Where the robots stand at tick 0, in order of id: evenly on a ring round the target or base
/// facing outwards, scattered over the free area with random headings, or gathered: as near the
/// target or base as there is room, no wall between them, facing outwards. In an operation: where
/// its script says.
///
/// Throws ConfigError when there is no room for one of them, or when its own place is not free.
[[nodiscard]] std::vector<WorldPose> start_poses(const WorldConfig& config, const Terrain& terrain,
                                                 std::uint64_t seed);

}  // namespace tacit
