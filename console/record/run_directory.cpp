#include "console/record/run_directory.h"

#include <system_error>
#include <utility>

#include "console/record/files.h"
#include "console/record/json.h"
#include "console/record/record_error.h"
#include "console/record/sha256.h"
#include "idl/types/config_error.h"

namespace tacit {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void refuse(const fs::path& path, const std::string& reason) {
  throw ConfigError(path.string() + ": " + reason);
}

void make_folder(const fs::path& path) {
  std::error_code error;
  fs::create_directories(path, error);
  if (error) {
    refuse(path, error.message());
  }
  for (const fs::directory_entry& entry : fs::directory_iterator(path, error)) {
    if (entry.path().filename() != "logs") {
      refuse(path, "is occupied (it holds " + entry.path().filename().string() +
                       "), wanted a new or empty directory");
    }
  }
  if (error) {
    refuse(path, error.message());
  }
}

std::string made_up_key(const RunFacts& facts, const fs::path& path) {
  return sha256_of_text(to_json(facts) + fs::absolute(path).lexically_normal().string());
}

std::string read_or_refuse(const fs::path& file) {
  try {
    return read_whole_file(file);
  } catch (const RecordError& error) {
    throw ConfigError(error.what());
  }
}

}  // namespace

RunDirectory::RunDirectory(fs::path path, RunFacts facts)
    : path_(fs::absolute(path).lexically_normal()), facts_(std::move(facts)) {}

RunDirectory RunDirectory::create(const fs::path& path, RunFacts facts,
                                  std::string_view scenario_toml) {
  make_folder(path);
  if (facts.key.empty()) {
    facts.key = made_up_key(facts, path);
  }
  RunDirectory directory(path, std::move(facts));
  try {
    write_whole_file(directory.scenario_file(), scenario_toml);
    write_whole_file(directory.path_ / "run.json", to_json(directory.facts_));
  } catch (const RecordError& error) {
    throw ConfigError(error.what());
  }
  return directory;
}

RunDirectory RunDirectory::open(const fs::path& path) {
  if (!fs::is_directory(path)) {
    refuse(path, "is not a directory, wanted a run directory");
  }
  const fs::path file = path / "run.json";
  if (!fs::exists(file)) {
    refuse(path, "holds no run.json, wanted a run directory");
  }
  return {path, facts_from_json(read_or_refuse(file), file.string())};
}

void RunDirectory::write_outcome(const RunOutcome& outcome) const {
  write_whole_file(metrics_file(), to_json(outcome));
}

void RunDirectory::sync() const {
  for (const fs::directory_entry& entry : fs::directory_iterator(path_)) {
    if (entry.is_regular_file()) {
      sync_file(entry.path());
    }
  }
  sync_file(path_);
}

std::optional<RunOutcome> RunDirectory::outcome() const {
  if (!fs::exists(metrics_file())) {
    return std::nullopt;
  }
  return outcome_from_json(read_or_refuse(metrics_file()), metrics_file().string());
}

}  // namespace tacit
