#include "robot_agent/brain/schemas/avoid_robots.h"

#include "idl/types/config_error.h"
#include "idl/types/repulsion.h"
#include "idl/types/shortest.h"

namespace tacit {
namespace {

BodyVec push_off(const std::vector<SeenObstacle>& robots, const AvoidRobots::Config& config) {
  BodyVec total;
  for (const SeenObstacle& robot : robots) {
    const double outer_m = config.reach_m + robot.radius_m;
    const double squared_m2 = robot.offset_m.squared_norm();
    if (squared_m2 >= outer_m * outer_m || squared_m2 == 0.0) continue;
    const double centre_m = std::sqrt(squared_m2);
    const double strength = repulsion(centre_m - robot.radius_m, config.reach_m, config.margin_m);
    const BodyVec away = (-1.0 / centre_m) * robot.offset_m;
    const BodyVec past{-away.y(), away.x()};
    total += (0.5 * strength) * (away + past);
  }
  return total;
}

}  // namespace

AvoidRobots::AvoidRobots(const Config& config) : config_(config) {
  if (!(config.margin_m < config.reach_m)) {
    throw ConfigError("the safety margin is " + shortest(config.margin_m) +
                      " m, wanted less than the sphere, which is " + shortest(config.reach_m) +
                      " m");
  }
}

BodyVec AvoidRobots::push(const Surroundings& around) {
  BodyVec total;
  if (config_.friends) total += push_off(around.premises.friends, config_);
  if (config_.enemies) total += push_off(around.premises.enemies, config_);
  return total;
}

}  // namespace tacit
