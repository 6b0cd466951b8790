#include "deploy/experiment/experiment_config.h"

#include <algorithm>
#include <array>
#include <string_view>

#include "console/metrics/tally.h"
#include "idl/types/config_error.h"

namespace tacit {
namespace {

constexpr std::array<std::string_view, 2> kTeamColumns{"robots", "runs"};

/// Whether the runs of any mission have the metric `key`.
bool is_metric(const std::string& key) {
  Tally guard;
  Tally forage;
  forage.add({0, ForageBegun{1}});
  for (const Tally* tally : {&guard, &forage}) {
    for (const Metric& metric : tally->metrics()) {
      if (metric.key == key) {
        return true;
      }
    }
  }
  return false;
}

/// One behind the last seed of training.
std::int64_t training_end(const ExperimentConfig& config) {
  double most = 0.0;
  for (const auto& team : config.teams) {
    most = std::max(most, team[1]);
  }
  return training_seed(config, static_cast<std::int64_t>(most));
}

bool seeds_overlap(const ExperimentConfig& config) {
  return config.held_out_first_seed < training_end(config) &&
         held_out_seed(config, config.held_out_runs) > config.first_seed;
}

void check_selection(const ExperimentConfig& config) {
  if (!is_metric(config.select_by)) {
    throw ConfigError("[experiment] select_by = \"" + config.select_by +
                      "\", wanted a metric, score_ticks for one");
  }
  if (config.rivals.empty()) {
    throw ConfigError("[experiment] select_by: wanted rivals to compare what is selected with");
  }
  if (config.held_out_runs < 2) {
    throw ConfigError("[experiment] held_out_runs = " + std::to_string(config.held_out_runs) +
                      ", wanted 2 or more where select_by is given");
  }
  if (seeds_overlap(config)) {
    throw ConfigError(
        "[experiment] held_out_first_seed = " + std::to_string(config.held_out_first_seed) +
        ", but the seeds " + std::to_string(config.first_seed) + " to " +
        std::to_string(training_end(config) - 1) + " are those of training, wanted others");
  }
}

void describe_what_varies(ExperimentConfig& config, ParameterVisitor& v) {
  v.text("scenario", config.scenario, {"", "The scenario's name or file. [ours]"});
  v.texts("scenarios", config.scenarios,
          {"", "Several in its place, crossed as factor \"scenario\". [paper: environments]"});
  v.texts("settings", config.settings,
          {"", "Parameters set for all runs, each \"section.key = value\". [ours]"});
  v.texts("factors", config.factors,
          {"", "Parameters varied, each \"section.key = value, value, …\"; all crossed. [ours]"});
  v.texts("variants", config.variants,
          {"",
           "Parameters varied together, each \"name: section.key = value; …\"; crossed as factor "
           "\"variant\". [paper: reward functions]"});
  v.texts(
      "rivals", config.rivals,
      {"", "Of the same form; crossed with scenarios and teams alone. [paper: handcrafted teams]"});
  v.rows("teams", config.teams, kTeamColumns, {1, 1e6},
         {"", "Team sizes, and how many runs or chains each cell gets. [paper]"});
}

void describe_runs(ExperimentConfig& config, ParameterVisitor& v) {
  v.integer("first_seed", config.first_seed, {1, 9e15},
            {"",
             "Run k of every cell begins at seed first_seed + k episodes, so cells are paired. "
             "[ours]"});
  v.integer("episodes", config.episodes, {1, 1e6},
            {"",
             "Runs in a row that make a chain: each robot begins with what it learned in the one "
             "before. [MissionLab]"});
  v.integer("evaluate", config.evaluate, {1, 1e6},
            {"", "A chain's metrics are means over its last so many runs. [ours]"});
}

void describe_report(ExperimentConfig& config, ParameterVisitor& v) {
  v.texts("measures", config.measures, {"", "Metrics that the report tabulates. [ours]"});
  v.text("compare", config.compare,
         {"", "Factor whose values are compared pairwise; empty for none. [ours]"});
  v.text(
      "select_by", config.select_by,
      {"",
       "Metric, smaller is better, that selects a cell for each scenario and team size; it meets "
       "the rivals on other seeds. Empty for none. [ours]"});
  v.integer("held_out_runs", config.held_out_runs, {0, 1e6},
            {"", "Runs or chains on those seeds, for the selected cell and each rival. [ours]"});
  v.integer("held_out_first_seed", config.held_out_first_seed, {1, 9e15},
            {"", "The first of those seeds. [ours]"});
}

}  // namespace

void describe(ExperimentConfig& config, ParameterVisitor& v) {
  v.section("experiment", "A battery of runs: one or more scenarios, varied.");
  v.text("name", config.name, {"", "What reports call it. [ours]"});
  v.text("description", config.description, {"", "What it is for. [ours]"});
  describe_what_varies(config, v);
  describe_runs(config, v);
  describe_report(config, v);
}

void check(const ExperimentConfig& config) {
  if (!config.select_by.empty()) {
    check_selection(config);
  } else if (config.held_out_runs > 0) {
    throw ConfigError("[experiment] held_out_runs = " + std::to_string(config.held_out_runs) +
                      ", but select_by is empty, wanted the metric to select by");
  }
}

std::vector<std::string> scenario_names(const ExperimentConfig& config) {
  return config.scenarios.empty() ? std::vector{config.scenario} : config.scenarios;
}

std::int64_t evaluated(const ExperimentConfig& config) {
  return std::min(config.evaluate, config.episodes);
}

}  // namespace tacit
