#pragma once

#include <vector>

#include "robot_agent/brain/fsa/automaton_plan.h"
#include "robot_agent/brain/roles/roles_config.h"

namespace tacit {

/// The automata of all roles, in the order of `Role`: the built-in ones, or those of the mission in
/// `config`. Throws ConfigError when that mission cannot be used or lacks a role.
[[nodiscard]] std::vector<AutomatonPlan> role_plans(const RolesConfig& config);

}  // namespace tacit
