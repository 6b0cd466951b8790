#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "idl/types/parameters.h"

namespace tacit {

/// A battery of runs: one or more scenarios, varied.
struct ExperimentConfig {
  std::string name = "unnamed";
  std::string description;
  std::string scenario = "guard";      ///< Name or file.
  std::vector<std::string> scenarios;  ///< In its place, several; crossed as factor "scenario".
  std::vector<std::string> settings;   ///< "section.key = value", the same for all runs.
  std::vector<std::string> factors;    ///< "section.key = value, value, …"; all are crossed.
  std::vector<std::string> variants;   ///< "name: setting; setting"; crossed as factor "variant".
  std::vector<std::string> rivals;     ///< The same; crossed with scenarios and teams alone.
  std::vector<std::vector<double>> teams{{6, 10}};  ///< Rows of robots, runs per cell.
  std::int64_t first_seed = 1;
  std::int64_t episodes = 1;  ///< Runs in a row that a run is made of; above 1 it is a chain.
  std::int64_t evaluate = 5;  ///< The last so many of them count; at most `episodes`.
  std::vector<std::string> measures{"mean_death_distance_m", "intercept_percent"};
  std::string compare;    ///< Factor whose values are compared pairwise on the same seeds.
  std::string select_by;  ///< Metric by which the best cells are selected; empty: none are.
  std::int64_t held_out_runs = 0;
  std::int64_t held_out_first_seed = 1'000'001;
};

/// Section `experiment`.
void describe(ExperimentConfig& config, ParameterVisitor& visitor);

/// Throws ConfigError when values that are each in range contradict one another.
void check(const ExperimentConfig& config);

/// The scenarios' names or files: `scenarios`, else the one `scenario`.
[[nodiscard]] std::vector<std::string> scenario_names(const ExperimentConfig& config);

/// How many episodes of a chain count.
[[nodiscard]] std::int64_t evaluated(const ExperimentConfig& config);

/// The seed at which run or chain `k` begins; each episode takes one seed.
[[nodiscard]] inline std::int64_t training_seed(const ExperimentConfig& config, std::int64_t k) {
  return config.first_seed + k * config.episodes;
}
[[nodiscard]] inline std::int64_t held_out_seed(const ExperimentConfig& config, std::int64_t k) {
  return config.held_out_first_seed + k * config.episodes;
}

}  // namespace tacit
