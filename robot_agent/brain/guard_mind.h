#pragma once

#include "robot_agent/brain/assemblage/actuator.h"
#include "robot_agent/brain/assemblage/assemblage.h"
#include "robot_agent/brain/brain_config.h"
#include "robot_agent/brain/learning/learner.h"
#include "robot_agent/brain/mind.h"
#include "robot_agent/brain/perception/perception.h"

namespace tacit {

/// A guard's mind: one assemblage, whose gains a learner sets.
class GuardMind final : public Mind {
 public:
  GuardMind(const BrainConfig& config, const Self& self);

  [[nodiscard]] Command decide(const Percept& percept) override;
  void report(Telemetry& out) const override;
  /// The policy is all that there is to remember.
  [[nodiscard]] std::string memory(std::string_view policy) const override {
    return std::string(policy);
  }
  [[nodiscard]] bool recall(std::string_view memory) override { return learner_->recall(memory); }
  [[nodiscard]] std::uint64_t lessons() const override { return 0; }
  [[nodiscard]] std::string policy() const override { return learner_->memory(); }
  void inherit(std::string_view policy, std::string_view name) override;

 private:
  RobotId robot_;
  Tick tick_ = 0;
  std::string learner_name_;
  std::unique_ptr<Learner> learner_;
  Perception perception_;
  Assemblage assemblage_;
  Actuator actuator_;
};

}  // namespace tacit
