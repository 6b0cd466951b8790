#pragma once

#include <filesystem>
#include <string>

#include "deploy/experiment/battery.h"

namespace tacit {

/// Two learners, two strategies, teams of one and two, three seeds, 20 simulated seconds each.
inline ExperimentConfig small_experiment() {
  ExperimentConfig config;
  config.name = "small";
  config.settings = {"run.duration_s = 20", "obstacles.coverage_percent = 1"};
  config.factors = {"brain.learner = static1, lm", "enemies.strategy = 1, 5"};
  config.teams = {{1, 2}, {2, 3}};
  config.first_seed = 11;
  config.compare = "brain.learner";
  return config;
}

inline Battery small_battery(const ExperimentConfig& config = small_experiment(),
                             const std::string& version = "1.0") {
  return {config, std::filesystem::path(TACIT_SOURCE_DIR) / "deploy/scenarios/guard.toml", version};
}

}  // namespace tacit
