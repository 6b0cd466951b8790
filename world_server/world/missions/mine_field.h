#pragma once

#include <cstdint>
#include <vector>

#include "world_server/world/terrain.h"
#include "world_server/world/world_config.h"

namespace tacit {

/// Where the mines lie at tick 0, in order of id: those at given places, then those laid by chance
/// in the scenario's layout.
///
/// Chance lays no mine nearer to the base than `keep_from_base_m`, nearer to the border than 1 m
/// (a ring lies where it is told to), within half a metre of another, or where obstacles and inner
/// walls leave no room for a robot beside it. Clusters are filled in turn.
///
/// Throws ConfigError when a given place lies in an obstacle, or when a mine finds no place (1000
/// misses in a row).
[[nodiscard]] std::vector<WorldVec> lay_mines(const WorldConfig& config, const Terrain& terrain,
                                              std::uint64_t seed);

}  // namespace tacit
