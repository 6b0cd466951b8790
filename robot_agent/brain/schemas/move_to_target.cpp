#include "robot_agent/brain/schemas/move_to_target.h"

#include <algorithm>

namespace tacit {

BodyVec MoveToTarget::push(const Surroundings& around) {
  if (!around.target_m) return {};
  const double range_m = around.target_m->norm();
  if (range_m < config_.near_m || range_m == 0.0) return {};
  const double strength = std::min(range_m / config_.unit_range_m, config_.max_push);
  return (strength / range_m) * *around.target_m;
}

void describe(MoveToTarget::Config& config, ParameterVisitor& visitor) {
  visitor.section("brain.move_to_target", "MoveToTarget: a pull towards the guarded target.");
  visitor.number("unit_range_m", config.unit_range_m, {0.001, 1e6},
                 {"m",
                  "Range at which the pull is 1, growing in proportion [ours: with a constant pull "
                  "a soldier's reach would be all or nothing]."});
  visitor.number("max_push", config.max_push, {0.0, 1000.0},
                 {"", "The strongest pull [ours: only bounds what cannot occur in the area]."});
  visitor.number("near_m", config.near_m, {0.0, 1000.0},
                 {"m", "No pull nearer than this [ours: as near as the target's own size]."});
}

}  // namespace tacit
