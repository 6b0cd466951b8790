#pragma once

#include "idl/types/operation_script.h"
#include "robot_agent/brain/brain_config.h"
#include "robot_agent/brain/mission/compile.h"

namespace tacit {

/// The operation's part of `brain_defaults`, `describe` and `check`.
[[nodiscard]] BrainConfig operation_defaults();
void describe_operation(BrainConfig& config, ParameterVisitor& visitor);
void check_operation(const BrainConfig& config);

/// What `robot` is to do. Throws ConfigError when the script's mission cannot be carried out, or
/// has no part for it.
[[nodiscard]] RobotPlan robot_plan(const OperationScript& script, RobotId robot);
/// Where it is told that it starts. Throws ConfigError when the script does not say.
[[nodiscard]] WorldPose start_of(const OperationScript& script, RobotId robot);

}  // namespace tacit
