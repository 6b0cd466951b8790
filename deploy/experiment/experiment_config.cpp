#include "deploy/experiment/experiment_config.h"

#include <algorithm>
#include <array>
#include <string_view>

#include "idl/types/config_error.h"

namespace tacit {
namespace {

constexpr std::array<std::string_view, 2> kTeamColumns{"robots", "runs"};
constexpr std::string_view kBlank = " \t";

std::string trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(kBlank);
  if (first == std::string_view::npos) {
    return {};
  }
  return std::string(text.substr(first, text.find_last_not_of(kBlank) - first + 1));
}

Setting split(const std::string& text, const char* form) {
  const std::size_t equals = text.find('=');
  const std::string path = trimmed(std::string_view(text).substr(0, equals));
  const std::string value =
      equals == std::string::npos ? "" : trimmed(std::string_view(text).substr(equals + 1));
  if (path.find('.') == std::string::npos || value.empty()) {
    throw ConfigError("[experiment] found \"" + text + "\", wanted \"" + form + '"');
  }
  return {path, value};
}

}  // namespace

void describe(ExperimentConfig& config, ParameterVisitor& v) {
  v.section("experiment", "A battery of runs: one scenario, varied.");
  v.text("name", config.name, {"", "What reports call it. [ours]"});
  v.text("description", config.description, {"", "What it is for. [ours]"});
  v.text("scenario", config.scenario, {"", "The scenario's name or file. [ours]"});
  v.texts("settings", config.settings,
          {"", "Parameters set for all runs, each \"section.key = value\". [ours]"});
  v.texts("factors", config.factors,
          {"", "Parameters varied, each \"section.key = value, value, …\"; all crossed. [ours]"});
  v.rows("teams", config.teams, kTeamColumns, {1, 1e6},
         {"", "Team sizes, and how many runs each cell gets. [paper]"});
  v.integer("first_seed", config.first_seed, {1, 9e15},
            {"", "Run k of every cell has seed first_seed + k, so cells are paired. [ours]"});
  v.texts("measures", config.measures, {"", "Metrics that the report tabulates. [ours]"});
  v.text("compare", config.compare,
         {"", "Factor whose values are compared pairwise; empty for none. [ours]"});
}

Setting read_setting(const std::string& text) { return split(text, "section.key = value"); }

Factor read_factor(const std::string& text) {
  const Setting whole = split(text, "section.key = value, value, …");
  Factor factor{whole.path, {}};
  std::size_t start = 0;
  while (start <= whole.value.size()) {
    const std::size_t comma = std::min(whole.value.find(',', start), whole.value.size());
    const std::string value = trimmed(std::string_view(whole.value).substr(start, comma - start));
    if (value.empty()) {
      throw ConfigError("[experiment] factor \"" + text +
                        "\" has an empty value, wanted \"section.key = value, value, …\"");
    }
    factor.values.push_back(value);
    start = comma + 1;
  }
  return factor;
}

}  // namespace tacit
