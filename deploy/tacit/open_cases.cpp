#include "deploy/tacit/open_cases.h"

#include "deploy/tacit/say.h"
#include "idl/types/config_error.h"
#include "wizard_service/cases/seed.h"

namespace tacit {
namespace {

namespace fs = std::filesystem;

/// The file that is meant, in a folder that is there.
fs::path place_of(const CaseFileWish& wish) {
  if (wish.file.empty()) {
    const fs::path usual = cbr::usual_case_file();
    fs::create_directories(usual.parent_path());
    return usual;
  }
  const fs::path folder = fs::absolute(wish.file).parent_path();
  if (!fs::is_directory(folder)) {
    throw ConfigError("--cases: there is no directory " + folder.string());
  }
  if (fs::is_directory(wish.file)) {
    throw ConfigError("--cases: found the directory " + wish.file + ", wanted a file");
  }
  return wish.file;
}

fs::path seeds_of(const CaseFileWish& wish) {
  if (wish.seeds.empty()) return cbr::shipped_seeds();
  if (!fs::is_directory(wish.seeds)) {
    throw ConfigError("--seeds: there is no directory " + wish.seeds);
  }
  return wish.seeds;
}

}  // namespace

std::unique_ptr<cbr::CaseBase> open_cases(const CaseFileWish& wish) {
  const fs::path seeds = seeds_of(wish);
  const fs::path file = place_of(wish);
  const bool there = fs::exists(file);
  auto base = std::make_unique<cbr::CaseBase>(file);
  cbr::seed_if_new(*base, seeds);
  if (!there) {
    say("made the case base " + file.string() + "; it begins with " + std::to_string(base->size()) +
        " cases");
  }
  return base;
}

}  // namespace tacit
