#include "robot_agent/brain/schemas/avoid_obstacles.h"

#include "idl/types/config_error.h"
#include "idl/types/repulsion.h"
#include "idl/types/shortest.h"

namespace tacit {

AvoidObstacles::AvoidObstacles(const Config& config) : config_(config) {
  if (!(config.margin_m < config.reach_m)) {
    throw ConfigError("brain.avoid_obstacles: margin_m is " + shortest(config.margin_m) +
                      ", wanted less than reach_m, which is " + shortest(config.reach_m));
  }
}

BodyVec AvoidObstacles::push(const Surroundings& around) {
  BodyVec total;
  for (const SeenObstacle& obstacle : around.obstacles) {
    const double outer_m = config_.reach_m + obstacle.radius_m;
    const double squared_m2 = obstacle.offset_m.squared_norm();
    if (squared_m2 >= outer_m * outer_m || squared_m2 == 0.0) continue;
    const double centre_m = std::sqrt(squared_m2);
    const double strength =
        repulsion(centre_m - obstacle.radius_m, config_.reach_m, config_.margin_m);
    total -= (strength / centre_m) * obstacle.offset_m;
  }
  return total;
}

void describe(AvoidObstacles::Config& config, ParameterVisitor& visitor) {
  visitor.section("brain.avoid_obstacles", "AvoidObstacles: a push away from each obstacle.");
  visitor.number("reach_m", config.reach_m, {0.001, 1e6},
                 {"m", "Range to its surface at which an obstacle starts to push [MissionLab]."});
  visitor.number("margin_m", config.margin_m, {0.0, 1e6},
                 {"m",
                  "Range to its surface from which inwards the push outweighs all others "
                  "[MissionLab]."});
}

}  // namespace tacit
