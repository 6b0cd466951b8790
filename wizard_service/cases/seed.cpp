#include "wizard_service/cases/seed.h"

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <sstream>

#include "idl/types/config_error.h"
#include "wizard_service/cases/case_base_error.h"
#include "wizard_service/cases/case_text.h"

namespace tacit::cbr {
namespace {

namespace fs = std::filesystem;

std::string text_of(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  std::ostringstream text;
  text << in.rdbuf();
  if (!in.is_open() || in.bad()) throw CaseBaseError(file, "cannot be read");
  return text.str();
}

/// None when there is no such folder.
std::vector<fs::path> files_in(const fs::path& folder) {
  std::vector<fs::path> files;
  std::error_code error;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, error)) {
    if (entry.path().extension() == ".cdl") files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

}  // namespace

std::vector<Case> seeds_in(const fs::path& folder) {
  std::vector<Case> cases;
  for (const fs::path& file : files_in(folder)) {
    cases.push_back(case_from(text_of(file), file.string()));
    cases.back().origin = "seed";
  }
  return cases;
}

void seed_if_new(CaseBase& base, const fs::path& folder) {
  if (!base.was_used()) base.store(seeds_in(folder));
}

fs::path shipped_seeds() {
  std::error_code error;
  const fs::path program = fs::read_symlink("/proc/self/exe", error);
  fs::path installed = program.parent_path().parent_path() / "share/tacit/seed";
  if (fs::is_directory(installed, error)) return installed;
  return TACIT_SOURCE_SEEDS;
}

fs::path usual_case_file() {
  // NOLINTBEGIN(concurrency-mt-unsafe)
  const char* data = std::getenv("XDG_DATA_HOME");
  const char* home = std::getenv("HOME");
  // NOLINTEND(concurrency-mt-unsafe)
  if (data != nullptr && *data != '\0') return fs::path(data) / "tacit/cases.db";
  if (home != nullptr && *home != '\0') return fs::path(home) / ".local/share/tacit/cases.db";
  throw ConfigError("found neither XDG_DATA_HOME nor HOME, wanted --cases FILE");
}

}  // namespace tacit::cbr
