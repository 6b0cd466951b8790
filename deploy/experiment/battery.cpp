#include "deploy/experiment/battery.h"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <utility>

#include "console/record/run_store.h"
#include "deploy/lockstep/setup.h"
#include "idl/types/config_error.h"

namespace tacit {
namespace {

std::string read_text(const std::filesystem::path& path) {
  std::ifstream in(path, std::ios::binary);
  if (!std::filesystem::is_regular_file(path) || !in) {
    throw ConfigError(path.string() + ": cannot be read, wanted a scenario file (TOML)");
  }
  return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

}  // namespace

Battery::Battery(ExperimentConfig config, std::filesystem::path scenario_file, std::string version)
    : config_(std::move(config)),
      scenario_file_(std::move(scenario_file)),
      scenario_text_(read_text(scenario_file_)),
      version_(std::move(version)) {
  for (const std::string& text : config_.settings) {
    fixed_.push_back(read_setting(text));
  }
  for (const std::string& text : config_.factors) {
    factors_.push_back(read_factor(text));
  }
  require_compared_factor();
  expand();
  plan();
}

void Battery::require_compared_factor() const {
  const bool known = std::any_of(factors_.begin(), factors_.end(), [this](const Factor& factor) {
    return factor.path == config_.compare;
  });
  if (!config_.compare.empty() && !known) {
    throw ConfigError("[experiment] compare = \"" + config_.compare +
                      "\", wanted the section.key of one of the factors");
  }
}

void Battery::expand() {
  for (const auto& team : config_.teams) {
    std::vector<Cell> crossed{
        Cell{{}, static_cast<std::int64_t>(team[0]), static_cast<std::int64_t>(team[1])}};
    for (const Factor& factor : factors_) {
      std::vector<Cell> next;
      for (const Cell& cell : crossed) {
        for (const std::string& value : factor.values) {
          next.push_back(cell);
          next.back().levels.push_back({factor.path, value});
        }
      }
      crossed = std::move(next);
    }
    cells_.insert(cells_.end(), crossed.begin(), crossed.end());
  }
}

void Battery::plan() {
  std::int64_t most = 0;
  for (const Cell& cell : cells_) {
    most = std::max(most, cell.runs);
  }
  // Seed by seed, so that an unfinished battery already compares like with like.
  for (std::int64_t k = 0; k < most; ++k) {
    for (std::size_t i = 0; i < cells_.size(); ++i) {
      if (k < cells_[i].runs) {
        const std::int64_t seed = config_.first_seed + k;
        runs_.push_back({i, seed, repeatable_key(scenario(cells_[i], seed), seed, version_)});
      }
    }
  }
}

std::vector<Setting> Battery::settings(const Cell& cell, std::int64_t seed) const {
  std::vector<Setting> all = fixed_;
  all.insert(all.end(), cell.levels.begin(), cell.levels.end());
  all.push_back({"robots.count", std::to_string(cell.robots)});
  all.push_back({"run.seed", std::to_string(seed)});
  return all;
}

std::string Battery::scenario(const Cell& cell, std::int64_t seed) const {
  ScenarioFile file = ScenarioFile::parse(scenario_text_, scenario_file_.string());
  for (const Setting& setting : settings(cell, seed)) {
    file.set(setting.path, setting.value);
  }
  Setup setup = read_setup(file);
  return to_toml(describing(setup));
}

std::vector<std::string> Battery::command(const Cell& cell, std::int64_t seed) const {
  std::vector<std::string> words{"tacit", "run", config_.scenario, "--one-process"};
  for (const Setting& setting : settings(cell, seed)) {
    words.emplace_back("--set");
    words.push_back(setting.path + '=' + setting.value);
  }
  return words;
}

}  // namespace tacit
