#include "deploy/experiment/battery.h"

#include <algorithm>
#include <cassert>
#include <fstream>
#include <iterator>
#include <set>
#include <utility>

#include "console/record/run_store.h"
#include "deploy/lockstep/setup.h"
#include "idl/types/config_error.h"

namespace tacit {
namespace {

constexpr const char* kScenario = "scenario";
constexpr const char* kVariant = "variant";

std::string read_text(const std::filesystem::path& path) {
  std::ifstream in(path, std::ios::binary);
  if (!std::filesystem::is_regular_file(path) || !in) {
    throw ConfigError(path.string() + ": cannot be read, wanted a scenario file (TOML)");
  }
  return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

void require_different(const std::vector<std::string>& names, const std::string& what) {
  std::set<std::string> seen;
  for (const std::string& name : names) {
    if (!seen.insert(name).second) {
      throw ConfigError("[experiment] " + what + ": \"" + name +
                        "\" is there twice, wanted different names");
    }
  }
}

Factor named(const char* path, const std::vector<Variant>& variants) {
  Factor factor{path, {}};
  for (const Variant& variant : variants) {
    factor.values.push_back(variant.name);
  }
  return factor;
}

const Variant* find(const std::vector<Variant>& variants, const std::string& name) {
  const auto found = std::find_if(variants.begin(), variants.end(),
                                  [&name](const Variant& v) { return v.name == name; });
  return found != variants.end() ? &*found : nullptr;
}

}  // namespace

std::string Cell::level(const std::string& path) const {
  for (const Setting& setting : levels) {
    if (setting.path == path) {
      return setting.value;
    }
  }
  return "";
}

std::vector<Setting> Cell::levels_but(const std::string& path) const {
  std::vector<Setting> others;
  std::copy_if(levels.begin(), levels.end(), std::back_inserter(others),
               [&path](const Setting& setting) { return setting.path != path; });
  return others;
}

Battery::Battery(ExperimentConfig config, const std::vector<std::filesystem::path>& scenario_files,
                 std::string version)
    : config_(std::move(config)), version_(std::move(version)) {
  check(config_);
  read(scenario_files);
  name_factors();
  require_different_names();
  require_compared_factor();
  expand();
  plan();
}

void Battery::read(const std::vector<std::filesystem::path>& scenario_files) {
  const std::vector<std::string> names = scenario_names(config_);
  assert(names.size() == scenario_files.size());
  for (std::size_t i = 0; i < names.size(); ++i) {
    sources_.push_back({names[i], scenario_files[i].string(), read_text(scenario_files[i])});
  }
  for (const std::string& text : config_.settings) {
    fixed_.push_back(read_setting(text));
  }
  for (const std::string& text : config_.factors) {
    parameters_.push_back(read_factor(text));
  }
  for (const std::string& text : config_.variants) {
    variants_.push_back(read_variant(text));
  }
  for (const std::string& text : config_.rivals) {
    rivals_.push_back(read_variant(text));
  }
}

void Battery::name_factors() {
  if (!config_.scenarios.empty()) {
    factors_.push_back({kScenario, config_.scenarios});
  }
  std::vector<Variant> all = variants_;
  all.insert(all.end(), rivals_.begin(), rivals_.end());
  if (!all.empty()) {
    factors_.push_back(named(kVariant, all));
  }
  factors_.insert(factors_.end(), parameters_.begin(), parameters_.end());
}

void Battery::require_different_names() const {
  std::vector<std::string> paths;
  for (const Factor& factor : factors_) {
    paths.push_back(factor.path);
    if (factor.path == kScenario || factor.path == kVariant) {
      require_different(factor.values,
                        factor.path == kScenario ? "scenarios" : "variants and rivals");
    }
  }
  require_different(paths, "factors");
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

std::vector<Factor> Battery::own_factors() const {
  std::vector<Factor> own;
  if (!config_.scenarios.empty()) {
    own.push_back({kScenario, config_.scenarios});
  }
  if (!variants_.empty()) {
    own.push_back(named(kVariant, variants_));
  }
  own.insert(own.end(), parameters_.begin(), parameters_.end());
  return own;
}

std::vector<Cell> Battery::crossed(Cell start, const std::vector<Factor>& factors) const {
  std::vector<Cell> crossed{std::move(start)};
  for (const Factor& factor : factors) {
    std::vector<Cell> next;
    for (const Cell& cell : crossed) {
      for (const std::string& value : factor.values) {
        next.push_back(cell);
        next.back().levels.push_back({factor.path, value});
      }
    }
    crossed = std::move(next);
  }
  return crossed;
}

void Battery::expand() {
  const auto add = [this](const std::vector<Cell>& cells) {
    cells_.insert(cells_.end(), cells.begin(), cells.end());
  };
  for (const auto& team : config_.teams) {
    Cell start{{}, static_cast<std::int64_t>(team[0]), static_cast<std::int64_t>(team[1]), false};
    add(crossed(start, own_factors()));
    if (!rivals_.empty()) {
      start.rival = true;
      std::vector<Factor> theirs{named(kVariant, rivals_)};
      if (!config_.scenarios.empty()) {
        theirs.insert(theirs.begin(), Factor{kScenario, config_.scenarios});
      }
      add(crossed(start, theirs));
    }
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
        runs_.push_back(planned(i, training_seed(config_, k)));
      }
    }
  }
}

PlannedRun Battery::planned(std::size_t cell, std::int64_t seed) const {
  std::string made_by = version_;
  if (config_.episodes > 1) {
    made_by += "\nepisodes " + std::to_string(config_.episodes) + "\nevaluate " +
               std::to_string(evaluated(config_));
  }
  return {cell, seed, repeatable_key(scenario(cells_.at(cell), seed), seed, made_by)};
}

const Battery::Source& Battery::source(const Cell& cell) const {
  const std::string name = cell.level(kScenario);
  const auto found = std::find_if(sources_.begin(), sources_.end(),
                                  [&name](const Source& s) { return s.name == name; });
  return found != sources_.end() ? *found : sources_.front();
}

const std::string& Battery::scenario_name(const Cell& cell) const { return source(cell).name; }

std::vector<Setting> Battery::settings(const Cell& cell, std::int64_t seed) const {
  std::vector<Setting> all = fixed_;
  for (const Setting& level : cell.levels) {
    if (level.path == kVariant) {
      const Variant* variant = find(cell.rival ? rivals_ : variants_, level.value);
      all.insert(all.end(), variant->settings.begin(), variant->settings.end());
    } else if (level.path != kScenario) {
      all.push_back(level);
    }
  }
  all.push_back({"robots.count", std::to_string(cell.robots)});
  all.push_back({"run.seed", std::to_string(seed)});
  return all;
}

std::string Battery::scenario(const Cell& cell, std::int64_t seed) const {
  const Source& from = source(cell);
  ScenarioFile file = ScenarioFile::parse(from.text, from.path);
  for (const Setting& setting : settings(cell, seed)) {
    file.set(setting.path, setting.value);
  }
  Setup setup = read_setup(file);
  return to_toml(describing(setup));
}

std::vector<std::string> Battery::command(const Cell& cell, std::int64_t seed) const {
  std::vector<std::string> words{"tacit", "run", scenario_name(cell), "--one-process"};
  if (config_.episodes > 1) {
    words = {"tacit",
             "learn",
             scenario_name(cell),
             "--episodes",
             std::to_string(config_.episodes),
             "--evaluate",
             std::to_string(evaluated(config_)),
             "--one-process"};
  }
  for (const Setting& setting : settings(cell, seed)) {
    words.emplace_back("--set");
    words.push_back(setting.path + '=' + setting.value);
  }
  if (config_.episodes > 1) {
    words.emplace_back("--json");
  }
  return words;
}

}  // namespace tacit
