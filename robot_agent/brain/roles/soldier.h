#pragma once

#include "robot_agent/brain/fsa/automaton_plan.h"
#include "robot_agent/brain/roles/roles_config.h"

namespace tacit {

///  goes for enemies in sight before they reach teammates.
[[nodiscard]] AutomatonPlan soldier(const RolesConfig& config);

}  // namespace tacit
