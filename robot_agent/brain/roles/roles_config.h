#pragma once

#include <string>

#include "idl/types/parameters.h"

namespace tacit {

/// What the automata of all roles are made with: how near is near, and how strong each schema is.
struct RolesConfig {
  double near_mine_m = 0.45;
  double pick_up_reach_m = 0.5;
  double near_base_m = 0.8;
  double drop_reach_m = 1.0;
  double near_disabled_m = 1.0;
  double wander_gain = 0.8;
  double approach_gain = 1.0;
  double approach_noise_gain = 0.1;
  double pursuit_gain = 2.0;
  double avoid_obstacles_gain = 0.5;
  double avoid_teammates_gain = 0.5;
  std::string mission;  ///< In which robots named as the roles say what those do; empty: as above.
};

void describe(RolesConfig& config, ParameterVisitor& visitor);

/// Throws ConfigError when a near range lies beyond the reach that belongs to it.
void check(const RolesConfig& config);

}  // namespace tacit
