#pragma once

#include "robot_agent/brain/fsa/automaton_plan.h"
#include "robot_agent/brain/roles/roles_config.h"

namespace tacit {

///  goes to disabled teammates and gets them going again.
[[nodiscard]] AutomatonPlan mechanic(const RolesConfig& config);

}  // namespace tacit
