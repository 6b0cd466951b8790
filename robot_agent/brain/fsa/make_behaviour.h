#pragma once

#include <memory>

#include "robot_agent/brain/fsa/automaton_plan.h"
#include "robot_agent/brain/fsa/behaviour.h"

namespace tacit {

/// What `state` says is done in it. Throws ConfigError when that cannot be.
[[nodiscard]] std::unique_ptr<Behaviour> make_behaviour(const StatePlan& state,
                                                        const SchemaConfigs& configs,
                                                        const Self& self);

}  // namespace tacit
