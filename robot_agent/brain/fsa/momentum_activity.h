#pragma once

#include <memory>
#include <optional>

#include "robot_agent/brain/fsa/automaton_plan.h"
#include "robot_agent/brain/fsa/behaviour.h"
#include "robot_agent/brain/learning/robot_momentum.h"

namespace tacit {

/// A behavioural assemblage whose gains follow learning momentum for one robot: to the goal, away
/// from obstacles and robots, noise, and the operator's joystick. The gains stay with the state
/// when it is left and entered again.
class MomentumActivity final : public Behaviour {
 public:
  /// Throws ConfigError as `make_schema` does.
  MomentumActivity(const MomentumPlan& plan, const Self& self);

  void enter(const Entry& entry) override;
  [[nodiscard]] Doing step(const Surroundings& around) override;
  void report(std::vector<SchemaShare>& shares) const override;
  void note(Record& record) const override;
  [[nodiscard]] bool resume(RecordReader& record) override;

 private:
  [[nodiscard]] double to_goal_m(const Surroundings& around) const;
  [[nodiscard]] double pushing_obstacles(const Surroundings& around) const;
  void apply();

  MomentumPlan plan_;
  Self self_;
  RobotMomentum momentum_;
  std::unique_ptr<Schema> goal_;
  std::optional<AvoidObstacles> obstacles_;
  std::optional<AvoidRobots> robots_;
  std::optional<Noise> noise_;
  Telop telop_;
  std::optional<OdometryVec> last_m_;
  std::vector<SchemaShare> shares_;  ///< In the last step.
};

}  // namespace tacit
