#pragma once

#include <optional>
#include <vector>

#include "robot_agent/brain/assemblage/actuator.h"
#include "robot_agent/brain/brain_config.h"
#include "robot_agent/brain/fsa/automaton.h"
#include "robot_agent/brain/learning/role_selector.h"
#include "robot_agent/brain/mind.h"
#include "robot_agent/brain/perception/forage_perception.h"

namespace tacit {

/// A forager's mind: a selector chooses the role, whose automaton decides what to do.
///
/// In the tick in which a role is entered the output is empty. A disabled robot does nothing, nor
/// does its selector; once revived, it begins the role that its selector then chooses.
class ForageMind final : public Mind {
 public:
  /// Throws ConfigError when an automaton or the selector cannot be.
  ForageMind(const BrainConfig& config, const Self& self);

  [[nodiscard]] Command decide(const Percept& percept) override;
  void report(Telemetry& out) const override;
  [[nodiscard]] std::string memory(std::string_view policy) const override;
  [[nodiscard]] bool recall(std::string_view memory) override;
  [[nodiscard]] std::uint64_t lessons() const override { return selector_->lessons(); }
  [[nodiscard]] std::string policy() const override { return selector_->policy(); }
  void inherit(std::string_view policy, std::string_view name) override {
    selector_->inherit(policy, name);
  }

 private:
  [[nodiscard]] Doing act(const Surroundings& around);
  [[nodiscard]] Automaton& automaton(Role role) { return automata_[index(role)]; }
  [[nodiscard]] const Automaton& automaton(Role role) const { return automata_[index(role)]; }
  [[nodiscard]] RunStand stand() const;
  [[nodiscard]] bool knows(const RunStand& stand) const;

  RobotId robot_;
  Tick tick_ = 0;
  std::string learner_name_;
  TriggerRanges ranges_;
  std::unique_ptr<RoleSelector> selector_;
  ForagePerception perception_;
  std::vector<Automaton> automata_;  ///< One per role.
  Actuator actuator_;
  std::optional<Role> role_;  ///< Empty before the first decision of an able robot.
  TriggerSet triggers_;
  bool disabled_ = false;
};

}  // namespace tacit
