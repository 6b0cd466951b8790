#pragma once

#include <filesystem>
#include <string>

#include "idl/types/ids.h"
#include "robot_agent/brain/brain.h"

namespace tacit {

/// What an agent takes from a scenario file.
struct Soldier {
  BrainConfig brain;
  std::uint64_t seed = 1;
  std::string digest;  ///< Of the file, to be shown to the world server.
};

/// Reads the brain's part of the scenario; the world's is the world server's affair. Throws
/// ConfigError.
[[nodiscard]] Soldier read_soldier(const std::filesystem::path& file);

}  // namespace tacit
