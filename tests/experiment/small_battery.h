#pragma once

#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "console/record/run_store.h"
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

/// Scenarios are those that ship.
inline Battery small_battery(const ExperimentConfig& config = small_experiment(),
                             const std::string& version = "1.0") {
  std::vector<std::filesystem::path> files;
  for (const std::string& name : scenario_names(config)) {
    files.push_back(std::filesystem::path(TACIT_SOURCE_DIR) / "deploy/scenarios" /
                    (name + ".toml"));
  }
  return {config, files, version};
}

/// Three chains of four runs, of which two count, for two speeds of the enemy and a rival.
inline ExperimentConfig small_contest() {
  ExperimentConfig config;
  config.name = "contest";
  config.settings = {"run.duration_s = 5", "obstacles.coverage_percent = 0"};
  config.factors = {"enemies.speed_mps = 1.5, 2.0"};
  config.rivals = {"fixed: brain.learner = static1"};
  config.teams = {{2, 3}};
  config.episodes = 4;
  config.evaluate = 2;
  config.measures = {"created"};
  config.select_by = "created";
  config.held_out_runs = 2;
  config.held_out_first_seed = 1001;
  return config;
}

/// Gives a run its metrics.
using MetricsOf = std::function<std::vector<RecordedMetric>(const Cell& cell, std::int64_t seed)>;

/// Fills a store by hand, so that every figure of a report can be worked out on paper.
inline void fill(RunStore& store, const Battery& battery, std::span<const PlannedRun> runs,
                 const MetricsOf& metrics) {
  for (const PlannedRun& run : runs) {
    RunRow row;
    row.facts.key = run.key;
    row.facts.seed = run.seed;
    row.outcome.complete = true;
    row.outcome.metrics = metrics(battery.cells()[run.cell], run.seed);
    store.add(row);
  }
}

}  // namespace tacit
