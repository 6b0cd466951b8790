#include "console/server/library.h"

#include <map>
#include <system_error>

#include "idl/types/config_error.h"
#include "idl/types/nearest_word.h"

namespace tacit {

namespace fs = std::filesystem;

std::vector<fs::path> Library::files() const {
  std::map<std::string, fs::path> by_name;
  for (const fs::path& folder : folders_) {
    std::error_code error;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder, error)) {
      if (entry.path().extension() == ending_) {
        by_name.emplace(entry.path().stem().string(), entry.path());
      }
    }
  }
  std::vector<fs::path> files;
  for (const auto& [name, file] : by_name) files.push_back(file);
  return files;
}

fs::path Library::find(const std::string& name) const {
  std::vector<std::string> names;
  for (const fs::path& file : files()) {
    if (file.stem() == name || file.filename() == name) return file;
    names.push_back(file.stem().string());
  }
  throw ConfigError("there is no " + name + ending_ + did_you_mean(name, names));
}

}  // namespace tacit
