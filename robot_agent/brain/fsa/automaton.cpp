#include "robot_agent/brain/fsa/automaton.h"

#include <algorithm>
#include <cassert>

#include "idl/types/config_error.h"

namespace tacit {
namespace {

[[noreturn]] void refuse(const AutomatonPlan& plan, const std::string& what) {
  throw ConfigError("automaton " + plan.name + ": " + what);
}

std::size_t place(const AutomatonPlan& plan, std::string_view state) {
  const auto found = std::find_if(plan.states.begin(), plan.states.end(),
                                  [state](const StatePlan& each) { return each.name == state; });
  return static_cast<std::size_t>(found - plan.states.begin());
}

void check_names(const AutomatonPlan& plan) {
  if (plan.states.empty()) refuse(plan, "it has no states");
  for (std::size_t i = 0; i < plan.states.size(); ++i) {
    const StatePlan& state = plan.states[i];
    if (place(plan, state.name) != i) refuse(plan, "state " + state.name + " occurs twice");
    for (const Rule& rule : state.rules) {
      if (place(plan, rule.next) < plan.states.size()) continue;
      refuse(plan, "state " + state.name + " goes to " + rule.next + ", wanted one of its states");
    }
  }
}

void check_reachable(const AutomatonPlan& plan) {
  std::vector<bool> reached(plan.states.size(), false);
  std::vector<std::size_t> open{0};
  reached[0] = true;
  while (!open.empty()) {
    const StatePlan& from = plan.states[open.back()];
    open.pop_back();
    for (const Rule& rule : from.rules) {
      const std::size_t next = place(plan, rule.next);
      if (!reached[next]) open.push_back(next);
      reached[next] = true;
    }
  }
  const auto missed = std::find(reached.begin(), reached.end(), false);
  if (missed == reached.end()) return;
  const auto index = static_cast<std::size_t>(missed - reached.begin());
  refuse(plan, "state " + plan.states[index].name + " cannot be reached");
}

Activity make_activity(const AutomatonPlan& plan, const StatePlan& state,
                       const SchemaConfigs& configs, const Self& self) {
  try {
    return {state.activity, configs, self};
  } catch (const ConfigError& error) {
    refuse(plan, "state " + state.name + ": " + error.what());
  }
}

}  // namespace

Automaton::Automaton(const AutomatonPlan& plan, const SchemaConfigs& configs, const Self& self) {
  check_names(plan);
  check_reachable(plan);
  for (const StatePlan& state : plan.states) {
    states_.push_back({state.name, make_activity(plan, state, configs, self), {}});
    for (const Rule& rule : state.rules) {
      states_.back().arcs.push_back({rule.trigger, place(plan, rule.next)});
    }
  }
}

void Automaton::enter(Tick now) { go(0, now); }

Doing Automaton::step(const Surroundings& around) {
  State& now = states_[current_];
  for (const Arc& arc : now.arcs) {
    if (!holds(arc.trigger, around)) continue;
    go(arc.next, around.tick);
    return {};
  }
  return now.activity.step(around);
}

bool Automaton::has(std::string_view state) const { return find(state) < states_.size(); }

void Automaton::resume(std::string_view state, Tick entered) {
  assert(has(state));
  go(find(state), entered);
}

void Automaton::go(std::size_t state, Tick now) {
  current_ = state;
  entered_ = now;
  states_[state].activity.rest();
  for (Arc& arc : states_[state].arcs) notify_entered(arc.trigger, now);
}

std::size_t Automaton::find(std::string_view state) const {
  const auto found = std::find_if(states_.begin(), states_.end(),
                                  [state](const State& each) { return each.name == state; });
  return static_cast<std::size_t>(found - states_.begin());
}

}  // namespace tacit
