#pragma once

#include <memory>
#include <string>

#include "robot_agent/brain/assemblage/actuator.h"
#include "robot_agent/brain/brain_config.h"
#include "robot_agent/brain/fsa/behaviour.h"
#include "robot_agent/brain/mind.h"
#include "robot_agent/brain/mission/compile.h"
#include "robot_agent/brain/perception/operation_perception.h"

namespace tacit {

/// The mind of a robot that carries out its part of a mission file.
class OperationMind final : public Mind {
 public:
  /// Throws ConfigError when the mission cannot be carried out, or has no part for this robot.
  OperationMind(const BrainConfig& config, const Self& self);

  [[nodiscard]] Command decide(const Percept& percept) override;
  void report(Telemetry& out) const override;
  /// The policy of this moment is the whole memory.
  [[nodiscard]] std::string memory(std::string_view policy) const override {
    return std::string(policy);
  }
  [[nodiscard]] bool recall(std::string_view memory) override;
  [[nodiscard]] std::uint64_t lessons() const override { return root_->lessons(); }
  [[nodiscard]] std::string policy() const override;
  void inherit(std::string_view policy, std::string_view name) override;

 private:
  [[nodiscard]] Command command(const Doing& doing) const;

  RobotId robot_;
  Tick tick_ = 0;
  std::shared_ptr<Errand> errand_ = std::make_shared<Errand>();
  RobotPlan plan_;
  OperationPerception perception_;
  std::unique_ptr<Behaviour> root_;
  Actuator actuator_;
  double cautious_mps_;
  bool begun_ = false;
};

}  // namespace tacit
