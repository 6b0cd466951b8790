#pragma once

#include "robot_agent/brain/fsa/automaton_plan.h"
#include "robot_agent/brain/roles/roles_config.h"

namespace tacit {

///  finds a mine, takes it to the base and drops it there.
[[nodiscard]] AutomatonPlan forager(const RolesConfig& config);

}  // namespace tacit
