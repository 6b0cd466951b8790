#pragma once

#include <array>

#include "robot_agent/brain/roles/forager.h"
#include "robot_agent/brain/roles/mechanic.h"
#include "robot_agent/brain/roles/role.h"
#include "robot_agent/brain/roles/soldier.h"

namespace tacit {

/// The automata of all roles, in the order of `Role`. A new role needs its file pair, its test, its
/// name in `role.h` and its line here.
inline constexpr std::array<AutomatonPlan (*)(const RolesConfig&), kRoles> kRolePlans{
    forager, soldier, mechanic};

}  // namespace tacit
