#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "robot_agent/brain/fsa/automaton_plan.h"
#include "robot_agent/brain/fsa/behaviour.h"

namespace tacit {

/// A finite state automaton that runs a behaviour in each state (MissionLab's FSA).
///
/// At most one transition per tick: the rules of the current state alone are tried, in their
/// order, and the first whose trigger fires wins. In the tick in which a state is entered the
/// output is empty; its behaviour counts from the next tick on. An automaton in a state of another
/// begins anew whenever that state is entered; the outer one's rules are tried first.
class Automaton final : public Behaviour {
 public:
  /// Throws ConfigError, naming automaton and state, when there are no states, a name occurs twice,
  /// a rule leads nowhere, a state cannot be reached, or a behaviour cannot be.
  Automaton(const AutomatonPlan& plan, const SchemaConfigs& configs, const Self& self);

  /// Enters the initial state.
  void enter(const Entry& entry) override { go(0, entry); }
  [[nodiscard]] Doing step(const Surroundings& around) override;
  void report(std::vector<SchemaShare>& shares) const override;
  void name_states(std::string& path) const override;
  /// The current state's.
  [[nodiscard]] std::span<const Word> exit() const override;
  void note(Record& record) const override;
  [[nodiscard]] bool resume(RecordReader& record) override;
  void begin_run() override;
  [[nodiscard]] std::uint64_t lessons() const override;

  /// The current state's name, and when and where it was entered.
  [[nodiscard]] std::string_view state() const { return states_[current_].name; }
  [[nodiscard]] const Entry& entered() const { return entered_; }
  [[nodiscard]] bool has(std::string_view state) const;
  /// Goes on in a state entered at an earlier tick; `has(state)`.
  void resume(std::string_view state, const Entry& entered);

 private:
  struct Arc {
    Trigger trigger;
    std::size_t next;  ///< Into the states.
  };
  struct State {
    std::string name;
    std::unique_ptr<Behaviour> behaviour;
    std::vector<Arc> arcs;
  };

  void go(std::size_t state, const Entry& entry);
  [[nodiscard]] std::size_t find(std::string_view state) const;

  std::vector<State> states_;
  std::size_t current_ = 0;
  Entry entered_;
};

}  // namespace tacit
