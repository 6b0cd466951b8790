#include "robot_agent/brain/operation_config.h"

#include "idl/types/config_error.h"

namespace tacit {
namespace {

std::string called(RobotId robot) { return "robot " + std::to_string(robot.value); }

}  // namespace

// MissionLab's Pioneer of the usability test: 0.2 m/s, at most 0.5.
BrainConfig operation_defaults() {
  BrainConfig config;
  config.mission = MissionKind::Operation;
  config.learner = "mission";
  config.actuator.base_mps = 0.2;
  config.actuator.max_mps = 0.5;
  return config;
}

void describe_operation(BrainConfig& config, ParameterVisitor& visitor) {
  visitor.section("brain", "The robots' brains.");
  visitor.choice("learner", config.learner, kOperationLearners,
                 {"", "What decides: the mission file [MissionLab]."});
  describe(config.actuator, visitor);
}

void check_operation(const BrainConfig& config) {
  const OperationScript& script = config.script;
  std::size_t parts = compile_mission(script.mission, "operation.mission").size();
  if (!script.extras.empty()) parts += compile_mission(script.extras, "operation.extras").size();
  if (parts != script.starts.size()) {
    throw ConfigError("operation.starts has " + std::to_string(script.starts.size()) +
                      " rows, wanted one for each of the missions' " + std::to_string(parts) +
                      " robots");
  }
}

RobotPlan robot_plan(const OperationScript& script, RobotId robot) {
  const std::size_t index = robot.value - 1U;
  std::vector<RobotPlan> team = compile_mission(script.mission, "operation.mission");
  if (index < team.size()) return std::move(team[index]);
  if (script.extras.empty()) {
    throw ConfigError(called(robot) + " has no part in operation.mission, which is for " +
                      std::to_string(team.size()));
  }
  std::vector<RobotPlan> extras = compile_mission(script.extras, "operation.extras");
  const std::size_t place = index - team.size();
  if (place < extras.size()) return std::move(extras[place]);
  throw ConfigError(called(robot) + " has no part in operation.mission and operation.extras");
}

WorldPose start_of(const OperationScript& script, RobotId robot) {
  const std::size_t index = robot.value - 1U;
  if (index >= script.starts.size() || script.starts[index].size() != 3) {
    throw ConfigError("operation.starts has no row x, y, heading for " + called(robot));
  }
  const std::vector<double>& row = script.starts[index];
  return {{row[0], row[1]}, Heading::from_rad(row[2] * kPi / 180.0)};
}

}  // namespace tacit
