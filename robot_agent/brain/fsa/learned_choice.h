#pragma once

#include <memory>
#include <string>
#include <vector>

#include "robot_agent/brain/fsa/automaton_plan.h"
#include "robot_agent/brain/fsa/behaviour.h"

namespace tacit {

/// Learns which of some behaviours to run in which state (MissionLab's QLEARN operator).
///
/// The state counts the triggers that fire, the first as the lowest bit, and the action under way:
/// action + actions * triggers. Every tick the table is queried with each reward whose state and
/// action match; with 0 when none does but the triggers have changed, or when nothing was asked for
/// `action_timeout` ticks. In a tick in which the action changes the output is empty.
class LearnedChoice final : public Behaviour {
 public:
  static constexpr std::size_t kMostTriggers = 12;

  /// Throws ConfigError when there is no action, when there are too many triggers, when a
  /// reinforcer names no state or action, or when an action cannot be.
  LearnedChoice(const ChoicePlan& plan, const SchemaConfigs& configs, const Self& self);

  /// Begins with the first action; what was learned stays.
  void enter(const Entry& entry) override;
  [[nodiscard]] Doing step(const Surroundings& around) override;
  void report(std::vector<SchemaShare>& shares) const override;
  void name_states(std::string& path) const override;
  void note(Record& record) const override;
  [[nodiscard]] bool resume(RecordReader& record) override;
  /// The rates decay, as at the start of each run.
  void begin_run() override;
  [[nodiscard]] std::uint64_t lessons() const override { return learner_.table().updates; }

 private:
  [[nodiscard]] std::size_t firing(const Surroundings& around) const;
  /// The action to run now.
  [[nodiscard]] std::size_t choose(const Surroundings& around);

  std::vector<std::string> names_;
  std::vector<std::unique_ptr<Behaviour>> actions_;
  std::vector<Trigger> triggers_;
  std::vector<ChoicePlan::Reinforcer> reinforcers_;
  Tick action_timeout_;
  QLearner learner_;
  std::size_t action_ = 0;
  std::size_t fired_ = 0;  ///< In the last tick.
  bool asked_ = false;     ///< Since the state was entered.
  Tick last_query_ = 0;
};

}  // namespace tacit
