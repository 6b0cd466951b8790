#pragma once

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <string_view>
#include <vector>

#include "wizard_service/cases/case_text.h"
#include "wizard_service/cbr/case_index.h"

namespace tacit::cbr::testing {

/// The text of a file of the source tree.
inline std::string source_text(const std::filesystem::path& file) {
  std::ifstream in(std::filesystem::path(TACIT_SOURCE_DIR) / file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

/// The files of the cases that ship, by name.
inline std::vector<std::filesystem::path> seed_files() {
  std::vector<std::filesystem::path> files;
  for (const auto& entry :
       std::filesystem::directory_iterator(TACIT_SOURCE_DIR "/wizard_service/seed")) {
    files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

/// The cases that ship, or those of them whose files' names begin with `prefix`; each one's origin
/// is its file's name without the ending.
class Shelf final : public CaseSource {
 public:
  explicit Shelf(std::string_view prefix = {}) {
    for (const std::filesystem::path& file : seed_files()) {
      if (!file.stem().string().starts_with(prefix)) continue;
      cases_.push_back(case_from(source_text(file), file.stem().string()));
      cases_.back().id = cases_.size();
    }
  }
  const Case& find(CaseId id) override { return cases_.at(id - 1); }
  [[nodiscard]] const std::vector<Case>& all() const { return cases_; }
  [[nodiscard]] CaseIndex index() const {
    std::vector<CaseHead> heads;
    for (const Case& one : cases_) heads.push_back({one.id, one.features, 0});
    return CaseIndex(heads);
  }

 private:
  std::vector<Case> cases_;
};

}  // namespace tacit::cbr::testing
