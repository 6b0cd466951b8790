#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "console/record/policy_folder.h"
#include "console/record/run.h"

namespace tacit {

/// The folder in which a run is kept: scenario.toml (as resolved), run.json (RunFacts),
/// events.jsonl, metrics.json (RunOutcome, once the run is over) and trajectories.csv if asked for;
/// the policies that the run began with, if there were any, and what was learned in it.
class RunDirectory {
 public:
  /// Makes `path`, which must be new or empty but for a folder `logs`, and writes scenario and
  /// facts there. Throws ConfigError.
  [[nodiscard]] static RunDirectory create(const std::filesystem::path& path, RunFacts facts,
                                           std::string_view scenario_toml);
  /// A run directory that exists. Throws ConfigError when `path` is none, naming the file and what
  /// is wrong with it.
  [[nodiscard]] static RunDirectory open(const std::filesystem::path& path);

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }
  [[nodiscard]] const RunFacts& facts() const { return facts_; }
  [[nodiscard]] std::filesystem::path scenario_file() const { return path_ / "scenario.toml"; }
  [[nodiscard]] std::filesystem::path events_file() const { return path_ / "events.jsonl"; }
  [[nodiscard]] std::filesystem::path trajectories_file() const {
    return path_ / "trajectories.csv";
  }
  [[nodiscard]] PolicyFolder inherited() const { return PolicyFolder(path_ / "inherited"); }
  [[nodiscard]] PolicyFolder learned() const { return PolicyFolder(path_ / "learned"); }
  [[nodiscard]] std::filesystem::path metrics_file() const { return path_ / "metrics.json"; }

  /// Throws RecordError; what was there before then stays.
  void write_outcome(const RunOutcome& outcome) const;
  /// Returns once everything in the directory outlasts the machine's power. Throws RecordError.
  void sync() const;
  /// Absent while the run has none. Throws ConfigError when metrics.json makes no sense.
  [[nodiscard]] std::optional<RunOutcome> outcome() const;

 private:
  RunDirectory(std::filesystem::path path, RunFacts facts);

  std::filesystem::path path_;  ///< Absolute.
  RunFacts facts_;
};

}  // namespace tacit
