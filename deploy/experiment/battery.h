#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "deploy/experiment/experiment_config.h"
#include "deploy/experiment/levels.h"

namespace tacit {

/// One combination of factor values and team size.
struct Cell {
  /// One per factor, in order. A rival has only those of "scenario" and "variant".
  std::vector<Setting> levels;
  std::int64_t robots = 0;
  std::int64_t runs = 0;
  bool rival = false;

  /// The value of factor `path`; empty when the cell has none.
  [[nodiscard]] std::string level(const std::string& path) const;
  /// The levels without that of `path`.
  [[nodiscard]] std::vector<Setting> levels_but(const std::string& path) const;
};

/// One run, or chain of runs, to be made.
struct PlannedRun {
  std::size_t cell = 0;
  std::int64_t seed = 0;  ///< Of the first episode.
  std::string key;        ///< Under which a RunStore keeps it.
};

/// All the runs of an experiment, expanded and checked.
class Battery {
 public:
  /// `scenario_files` are the files of `scenario_names(config)`, in that order. Throws ConfigError
  /// when any cell cannot be made.
  Battery(ExperimentConfig config, const std::vector<std::filesystem::path>& scenario_files,
          std::string version);

  [[nodiscard]] const ExperimentConfig& config() const { return config_; }
  /// "scenario" where there are several, "variant" where there are variants or rivals, and the
  /// parameters varied. Rivals are the last values of "variant".
  [[nodiscard]] const std::vector<Factor>& factors() const { return factors_; }
  [[nodiscard]] const std::vector<Cell>& cells() const { return cells_; }
  /// On the seeds of training; seed by seed.
  [[nodiscard]] const std::vector<PlannedRun>& runs() const { return runs_; }
  [[nodiscard]] const std::string& version() const { return version_; }

  /// The name or file of a cell's scenario.
  [[nodiscard]] const std::string& scenario_name(const Cell& cell) const;
  /// The resolved scenario of a run, as text.
  [[nodiscard]] std::string scenario(const Cell& cell, std::int64_t seed) const;
  /// The run of `cell` that begins at `seed`.
  [[nodiscard]] PlannedRun planned(std::size_t cell, std::int64_t seed) const;
  /// The command that makes this run, or chain, again.
  [[nodiscard]] std::vector<std::string> command(const Cell& cell, std::int64_t seed) const;

 private:
  struct Source {
    std::string name;
    std::string path;
    std::string text;
  };

  void read(const std::vector<std::filesystem::path>& scenario_files);
  void require_compared_factor() const;
  void require_different_names() const;
  void name_factors();
  void expand();
  void plan();
  [[nodiscard]] std::vector<Cell> crossed(Cell start, const std::vector<Factor>& factors) const;
  [[nodiscard]] std::vector<Factor> own_factors() const;
  [[nodiscard]] const Source& source(const Cell& cell) const;
  [[nodiscard]] std::vector<Setting> settings(const Cell& cell, std::int64_t seed) const;

  ExperimentConfig config_;
  std::string version_;
  std::vector<Source> sources_;
  std::vector<Setting> fixed_;
  std::vector<Factor> parameters_;
  std::vector<Variant> variants_;
  std::vector<Variant> rivals_;
  std::vector<Factor> factors_;
  std::vector<Cell> cells_;
  std::vector<PlannedRun> runs_;
};

}  // namespace tacit
