#pragma once

#include "robot_agent/brain/fsa/automaton_plan.h"
#include "robot_agent/brain/roles/roles_config.h"

namespace tacit {

/// The activities that roles are made of. All that move keep off obstacles and able teammates.

/// Noise alone: to look for what is not in sight.
[[nodiscard]] ActivityPlan wander(const RolesConfig& config);
/// Towards the nearest `thing`, with `act` on the way.
[[nodiscard]] ActivityPlan approach(Thing thing, const RolesConfig& config, Act act = Act::None);
/// After the nearest enemy, ready to destroy it.
[[nodiscard]] ActivityPlan pursue(const RolesConfig& config);
/// On the spot.
[[nodiscard]] ActivityPlan stand(Act act);

}  // namespace tacit
