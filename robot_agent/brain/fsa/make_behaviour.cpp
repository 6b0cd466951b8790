#include "robot_agent/brain/fsa/make_behaviour.h"

#include "robot_agent/brain/fsa/activity.h"
#include "robot_agent/brain/fsa/automaton.h"
#include "robot_agent/brain/fsa/learned_choice.h"
#include "robot_agent/brain/fsa/momentum_activity.h"

namespace tacit {

std::unique_ptr<Behaviour> make_behaviour(const StatePlan& state, const SchemaConfigs& configs,
                                          const Self& self) {
  if (state.nested) return std::make_unique<Automaton>(*state.nested, configs, self);
  if (state.choice) return std::make_unique<LearnedChoice>(*state.choice, configs, self);
  if (state.momentum) return std::make_unique<MomentumActivity>(*state.momentum, self);
  return std::make_unique<Activity>(state.activity, configs, self);
}

}  // namespace tacit
