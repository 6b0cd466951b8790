#include "robot_agent/brain/schemas/move_away_from.h"

#include "idl/types/config_error.h"
#include "idl/types/repulsion.h"
#include "idl/types/shortest.h"

namespace tacit {

MoveAwayFrom::MoveAwayFrom(ThingSet things, const Config& config)
    : things_(things), config_(config) {
  if (!(config.margin_m < config.reach_m)) {
    throw ConfigError("MoveAway: the safety margin is " + shortest(config.margin_m) +
                      " m, wanted less than the sphere, which is " + shortest(config.reach_m) +
                      " m");
  }
}

BodyVec MoveAwayFrom::push(const Surroundings& around) {
  const Nearest& thing = around.nearest_of(things_);
  if (!thing.known() || thing.squared_range_m2 == 0.0) return {};
  const double range_m = std::sqrt(thing.squared_range_m2);
  const double strength = repulsion(range_m - thing.radius_m, config_.reach_m, config_.margin_m);
  return (-strength / range_m) * thing.offset_m;
}

}  // namespace tacit
