#pragma once

#include <filesystem>
#include <string>

namespace tacit {

/// SHA-256 of a scenario file's bytes, as 64 lower-case hexadecimal digits: two processes with the
/// same digest read the same scenario. Throws ConfigError when the file cannot be read.
[[nodiscard]] std::string scenario_digest(const std::filesystem::path& file);

}  // namespace tacit
