#pragma once

#include <string>
#include <string_view>

#include "console/record/run.h"

namespace tacit {

/// What the console has to know of a scenario.
struct ScenarioFacts {
  std::string name;
  std::int64_t seed = 0;
  std::int64_t robots = 0;
  std::int64_t strategy = 0;
  std::string learner;
  double tick_s = 0.0;  ///< Simulated time per tick.
};

/// Takes them from the text of a resolved scenario, in which every parameter is written out.
/// Throws ConfigError naming `file` when one is missing.
[[nodiscard]] ScenarioFacts scenario_facts(std::string_view toml, const std::string& file);

}  // namespace tacit
