#pragma once

#include "deploy/tacit/run_plan.h"
#include "idl/scenario/scenario_file.h"

namespace tacit {

/// Whether the person asked for a mission file instead of a scenario.
[[nodiscard]] bool asks_for_mission(const RunWish& wish);

/// A scenario for the mission, the map and the extra robots of `wish`; its other settings are not
/// in it yet. Throws ConfigError when a file cannot be read or used.
[[nodiscard]] ScenarioFile operation_scenario(const RunWish& wish);

}  // namespace tacit
