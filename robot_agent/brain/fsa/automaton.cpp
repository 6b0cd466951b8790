#include "robot_agent/brain/fsa/automaton.h"

#include <algorithm>
#include <cassert>

#include "idl/types/config_error.h"
#include "robot_agent/brain/fsa/make_behaviour.h"

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

std::unique_ptr<Behaviour> make_state(const AutomatonPlan& plan, const StatePlan& state,
                                      const SchemaConfigs& configs, const Self& self) {
  try {
    return make_behaviour(state, configs, self);
  } catch (const ConfigError& error) {
    refuse(plan, "state " + state.name + ": " + error.what());
  }
}

}  // namespace

Automaton::Automaton(const AutomatonPlan& plan, const SchemaConfigs& configs, const Self& self) {
  check_names(plan);
  check_reachable(plan);
  for (const StatePlan& state : plan.states) {
    states_.push_back({state.name, make_state(plan, state, configs, self), {}});
    for (const Rule& rule : state.rules) {
      states_.back().arcs.push_back({rule.trigger, place(plan, rule.next)});
    }
  }
}

Doing Automaton::step(const Surroundings& around) {
  State& now = states_[current_];
  for (const Arc& arc : now.arcs) {
    if (!holds(arc.trigger, around, now.behaviour->exit())) continue;
    go(arc.next, {around.tick, around.odometry});
    return {};
  }
  return now.behaviour->step(around);
}

void Automaton::report(std::vector<SchemaShare>& shares) const {
  states_[current_].behaviour->report(shares);
}

void Automaton::name_states(std::string& path) const {
  path.append("/").append(state());
  states_[current_].behaviour->name_states(path);
}

std::span<const Word> Automaton::exit() const { return states_[current_].behaviour->exit(); }

bool Automaton::has(std::string_view state) const { return find(state) < states_.size(); }

void Automaton::resume(std::string_view state, const Entry& entered) {
  assert(has(state));
  go(find(state), entered);
}

// What other states have learned is kept too, so each notes its own.
void Automaton::note(Record& record) const {
  record.add_count(current_);
  record.add(entered_);
  for (const State& state : states_) state.behaviour->note(record);
}

bool Automaton::resume(RecordReader& record) {
  const std::size_t current = record.count(states_.size());
  const Entry entered = record.entry();
  if (!record.sound()) return false;
  go(current, entered);
  return std::all_of(states_.begin(), states_.end(),
                     [&record](const State& state) { return state.behaviour->resume(record); });
}

void Automaton::begin_run() {
  for (const State& state : states_) state.behaviour->begin_run();
}

std::uint64_t Automaton::lessons() const {
  std::uint64_t all = 0;
  for (const State& state : states_) all += state.behaviour->lessons();
  return all;
}

void Automaton::go(std::size_t state, const Entry& entry) {
  current_ = state;
  entered_ = entry;
  states_[state].behaviour->enter(entry);
  for (Arc& arc : states_[state].arcs) notify_entered(arc.trigger, entry);
}

std::size_t Automaton::find(std::string_view state) const {
  const auto found = std::find_if(states_.begin(), states_.end(),
                                  [state](const State& each) { return each.name == state; });
  return static_cast<std::size_t>(found - states_.begin());
}

}  // namespace tacit
