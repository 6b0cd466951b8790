#pragma once

#include <cstdint>
#include <string>

#include "idl/types/operation_script.h"
#include "idl/types/parameters.h"

namespace tacit {

/// How far and how surely robots hear one another.
struct SignalConfig {
  double range_m = 50.0;
  double missed_share = 0.0;
  bool blocked_by_walls = false;
};

/// What a robot of an operation can do with what is how near.
struct OperationReachConfig {
  double pick_up_m = 1.0;
  double drop_m = 1.0;
  double test_m = 1.0;
  double mark_m = 3.0;
  double intercept_m = 1.0;
};

/// Everything that only an operation's world has.
struct OperationConfig {
  OperationScript script;
  SignalConfig signal;
  OperationReachConfig reach;
  double doorway_range_m = 10.0;
  double point_reach_m = 1.0;
  double exposure_range_m = 20.0;
  std::string proceed = "at_once";  ///< "at_once" or "ask".
  // Not parameters but the map's: what is to be added to a place on it to have it in the world.
  double shift_x_m = 0.0;
  double shift_y_m = 0.0;
};

/// The part of an operation in `describe` and `check` of a `WorldConfig` with so many robots.
void describe(OperationConfig& config, ParameterVisitor& visitor);
void check(const OperationConfig& config, std::int64_t robots);

}  // namespace tacit
