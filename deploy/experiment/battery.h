#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "deploy/experiment/experiment_config.h"

namespace tacit {

/// One combination of factor values and team size.
struct Cell {
  std::vector<Setting> levels;  ///< One per factor, in order.
  std::int64_t robots = 0;
  std::int64_t runs = 0;
};

/// One run to be made.
struct PlannedRun {
  std::size_t cell = 0;
  std::int64_t seed = 0;
  std::string key;  ///< Under which a RunStore keeps it.
};

/// All the runs of an experiment, expanded and checked.
class Battery {
 public:
  /// `scenario_file` is the file that the experiment's scenario names. Throws ConfigError when any
  /// cell cannot be made.
  Battery(ExperimentConfig config, std::filesystem::path scenario_file, std::string version);

  [[nodiscard]] const ExperimentConfig& config() const { return config_; }
  [[nodiscard]] const std::vector<Factor>& factors() const { return factors_; }
  [[nodiscard]] const std::vector<Cell>& cells() const { return cells_; }
  [[nodiscard]] const std::vector<PlannedRun>& runs() const { return runs_; }
  [[nodiscard]] const std::string& version() const { return version_; }

  /// The resolved scenario of a run, as text.
  [[nodiscard]] std::string scenario(const Cell& cell, std::int64_t seed) const;
  /// The command that makes this run again.
  [[nodiscard]] std::vector<std::string> command(const Cell& cell, std::int64_t seed) const;

 private:
  void require_compared_factor() const;
  void expand();
  void plan();
  [[nodiscard]] std::vector<Setting> settings(const Cell& cell, std::int64_t seed) const;

  ExperimentConfig config_;
  std::filesystem::path scenario_file_;
  std::string scenario_text_;
  std::string version_;
  std::vector<Setting> fixed_;
  std::vector<Factor> factors_;
  std::vector<Cell> cells_;
  std::vector<PlannedRun> runs_;
};

}  // namespace tacit
