#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "robot_agent/brain/fsa/activity.h"

namespace tacit {

/// A finite state automaton that runs an activity in each state (MissionLab's FSA).
///
/// At most one transition per tick: the rules of the current state alone are tried, in their
/// order, and the first whose trigger fires wins. In the tick in which a state is entered the
/// output is empty; its activity counts from the next tick on.
class Automaton {
 public:
  /// Throws ConfigError, naming automaton and state, when there are no states, a name occurs twice,
  /// a rule leads nowhere, a state cannot be reached, or an activity cannot be.
  Automaton(const AutomatonPlan& plan, const SchemaConfigs& configs, const Self& self);

  /// Enters the initial state; that tick's output is empty. Comes before the first step.
  void enter(Tick now);
  /// One tick, ticks ascending.
  [[nodiscard]] Doing step(const Surroundings& around);

  /// The current state's name, and when it was entered.
  [[nodiscard]] std::string_view state() const { return states_[current_].name; }
  [[nodiscard]] Tick entered() const { return entered_; }
  [[nodiscard]] bool has(std::string_view state) const;
  /// Goes on in a state entered at an earlier tick; `has(state)`.
  void resume(std::string_view state, Tick entered);

  /// The shares in the last tick's output.
  void report(std::vector<SchemaShare>& shares) const { states_[current_].activity.report(shares); }

 private:
  struct Arc {
    Trigger trigger;
    std::size_t next;  ///< Into the states.
  };
  struct State {
    std::string name;
    Activity activity;
    std::vector<Arc> arcs;
  };

  void go(std::size_t state, Tick now);
  [[nodiscard]] std::size_t find(std::string_view state) const;

  std::vector<State> states_;
  std::size_t current_ = 0;
  Tick entered_ = 0;
};

}  // namespace tacit
