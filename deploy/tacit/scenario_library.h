#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace tacit {

/// The folders in which scenarios are looked up by name, in this order: those of the environment
/// variable TACIT_SCENARIOS (parted by colons), the one installed beside the programs, and the one
/// of the source tree.
[[nodiscard]] std::vector<std::filesystem::path> scenario_folders();

/// A scenario that can be asked for by name.
struct LibraryEntry {
  std::string name;  ///< The file's name without ".toml".
  std::filesystem::path file;
};

/// All of them, by name; of two with one name the first found.
[[nodiscard]] std::vector<LibraryEntry> scenario_library();

/// The file that `name_or_file` means: a path when it has a slash or ends in ".toml", else a name.
/// Throws ConfigError when there is none, with the names that there are.
[[nodiscard]] std::filesystem::path find_scenario(const std::string& name_or_file);

/// The mission or map that `name_or_file` means: a file that is there, else one of that name, its
/// ending left out or not, of those that ship ("missions", ".cdl" and "maps", ".ovl"). Throws
/// ConfigError when there is none, with the names that there are.
[[nodiscard]] std::filesystem::path find_shipped(const std::string& name_or_file,
                                                 const std::string& folder,
                                                 const std::string& ending);

/// The folder of this program's own file, where the other programs lie as well.
[[nodiscard]] std::filesystem::path program_folder();

}  // namespace tacit
