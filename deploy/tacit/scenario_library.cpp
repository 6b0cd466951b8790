#include "deploy/tacit/scenario_library.h"

#include <algorithm>
#include <cstdlib>
#include <sstream>

#include "idl/types/config_error.h"
#include "idl/types/nearest_word.h"

namespace tacit {
namespace {

namespace fs = std::filesystem;

std::string joined(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) {
    text += (text.empty() ? "" : ", ") + word;
  }
  return text.empty() ? "none" : text;
}

bool is_known(const std::vector<LibraryEntry>& entries, const std::string& name) {
  return std::any_of(entries.begin(), entries.end(),
                     [&name](const LibraryEntry& entry) { return entry.name == name; });
}

}  // namespace

fs::path program_folder() { return fs::read_symlink("/proc/self/exe").parent_path(); }

std::vector<fs::path> scenario_folders() {
  std::vector<fs::path> folders;
  const char* chosen = std::getenv("TACIT_SCENARIOS");  // NOLINT(concurrency-mt-unsafe)
  std::istringstream list(chosen != nullptr ? chosen : "");
  for (std::string folder; std::getline(list, folder, ':');) {
    folders.emplace_back(folder);
  }
  folders.push_back(program_folder().parent_path() / "share/tacit/scenarios");
  folders.emplace_back(TACIT_SOURCE_SCENARIOS);
  return folders;
}

std::vector<LibraryEntry> scenario_library() {
  std::vector<LibraryEntry> entries;
  for (const fs::path& folder : scenario_folders()) {
    std::error_code error;
    for (const fs::directory_entry& file : fs::directory_iterator(folder, error)) {
      const std::string name = file.path().stem().string();
      if (file.path().extension() == ".toml" && !is_known(entries, name)) {
        entries.push_back({name, file.path()});
      }
    }
  }
  std::sort(entries.begin(), entries.end(),
            [](const LibraryEntry& a, const LibraryEntry& b) { return a.name < b.name; });
  return entries;
}

fs::path find_scenario(const std::string& name_or_file) {
  if (name_or_file.find('/') != std::string::npos || name_or_file.ends_with(".toml")) {
    return name_or_file;
  }
  std::vector<std::string> names;
  for (const LibraryEntry& entry : scenario_library()) {
    if (entry.name == name_or_file) {
      return entry.file;
    }
    names.push_back(entry.name);
  }
  const std::string hint = did_you_mean(name_or_file, names);
  throw ConfigError("there is no scenario \"" + name_or_file + '"' + (hint.empty() ? "." : hint) +
                    " Wanted a file or one of: " + joined(names));
}

fs::path find_shipped(const std::string& name_or_file, const std::string& folder,
                      const std::string& ending) {
  if (fs::is_regular_file(name_or_file)) return name_or_file;
  std::vector<std::string> names;
  for (const fs::path& parent : {program_folder().parent_path() / "share/tacit" / folder,
                                 fs::path(TACIT_SOURCE_SCENARIOS).parent_path() / folder}) {
    std::error_code error;
    for (const fs::directory_entry& file : fs::directory_iterator(parent, error)) {
      if (file.path().extension() != ending) continue;
      const std::string stem = file.path().stem().string();
      if (stem == name_or_file || stem + ending == name_or_file) return file.path();
      names.push_back(stem);
    }
  }
  std::sort(names.begin(), names.end());
  throw ConfigError("there is no file " + name_or_file + did_you_mean(name_or_file, names) +
                    " Wanted a file (" + ending + ") or one of: " + joined(names));
}

}  // namespace tacit
