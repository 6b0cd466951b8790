#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "idl/types/ids.h"
#include "world_server/world/world_config.h"

namespace tacit {

/// What the world server takes from a scenario file.
struct Mission {
  WorldConfig world;
  std::uint64_t seed = 1;
  Tick last_tick = 1;
  std::string digest;  ///< Of the file; every agent must have read the same.
};

/// Reads the world's part of the scenario; the brain's is the agents' affair. `duration_s` stands
/// in for the scenario's own. Throws ConfigError.
[[nodiscard]] Mission read_mission(const std::filesystem::path& file,
                                   std::optional<double> duration_s);

}  // namespace tacit
