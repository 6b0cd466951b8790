#pragma once

#include <stdlib.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include "wizard_service/cbr/case.h"
#include "wizard_service/cbr/features.h"
#include "wizard_service/cbr/plan_cdl.h"

namespace tacit::cbr::testing {

namespace fs = std::filesystem;

inline std::string text_of(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

/// A case whose solution is a mission that ships.
inline Case shipped_case(const std::string& mission, Task task) {
  Case one;
  one.title = "From " + mission;
  one.origin = "test";
  one.features = usual_features(task);
  one.plan = plan_of(text_of(fs::path(TACIT_SOURCE_DIR) / "deploy/missions" / (mission + ".cdl")),
                     mission);
  one.features.robots = static_cast<int>(one.plan.robots.size());
  return one;
}

/// A folder of its own that goes with it.
class Folder {
 public:
  Folder() {
    std::string name = (fs::temp_directory_path() / "tacit-cases-XXXXXX").string();
    path_ = ::mkdtemp(name.data());
  }
  ~Folder() { fs::remove_all(path_); }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  [[nodiscard]] fs::path file() const { return path_ / "cases.db"; }

 private:
  fs::path path_;
};

}  // namespace tacit::cbr::testing
