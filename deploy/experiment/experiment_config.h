#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "idl/types/parameters.h"

namespace tacit {

/// A battery of runs: one scenario, varied.
struct ExperimentConfig {
  std::string name = "unnamed";
  std::string description;
  std::string scenario = "guard";     ///< Name or file.
  std::vector<std::string> settings;  ///< "section.key = value", the same for all runs.
  std::vector<std::string> factors;   ///< "section.key = value, value, …"; all are crossed.
  std::vector<std::vector<double>> teams{{6, 10}};  ///< Rows of robots, runs per cell.
  std::int64_t first_seed = 1;
  std::vector<std::string> measures{"mean_death_distance_m", "intercept_percent"};
  std::string compare;  ///< Factor whose values are compared pairwise on the same seeds.
};

/// Section `experiment`.
void describe(ExperimentConfig& config, ParameterVisitor& visitor);

/// A parameter and what it is given.
struct Setting {
  std::string path;   ///< "section.key"
  std::string value;  ///< As TOML; words may go without quotes.
  friend bool operator==(const Setting&, const Setting&) = default;
};

/// A parameter and the values it takes in turn.
struct Factor {
  std::string path;
  std::vector<std::string> values;
};

/// Reads "section.key = value". Throws ConfigError when it is not of that form.
[[nodiscard]] Setting read_setting(const std::string& text);
/// Reads "section.key = value, value, …". Throws ConfigError when it is not of that form.
[[nodiscard]] Factor read_factor(const std::string& text);

}  // namespace tacit
