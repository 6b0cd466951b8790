#pragma once

#include <filesystem>

namespace tacit {

/// Where locks lie: $XDG_RUNTIME_DIR/tacit, or else /tmp/tacit-<uid>.
[[nodiscard]] std::filesystem::path lease_folder();

/// Makes a folder that only this user can write to. Throws BusError when it cannot be one: others
/// could lay traps there.
void make_private(const std::filesystem::path& folder);

/// A descriptor of the file, made when it is not there, under a lock that ends with the descriptor,
/// however its holder ends; -1 when another holds it. Throws BusError when there can be no file.
[[nodiscard]] int open_locked(const std::filesystem::path& path);

}  // namespace tacit
