#include "robot_agent/brain/schemas/move_to.h"

#include <algorithm>

namespace tacit {
namespace {

/// The pull grows from 0 at the stand-off to 1 this much farther out, so that a follower comes to
/// rest instead of trembling [ours].
constexpr double kEaseM = 0.5;

}  // namespace

BodyVec MoveTo::push(const Surroundings& around) {
  const Nearest& goal = around.nearest_of(things_);
  if (!goal.known() || goal.squared_range_m2 == 0.0) return {};
  if (!goal.within(config_.max_range_m)) return {};
  const double range_m = std::sqrt(goal.squared_range_m2);
  if (config_.stand_off_m == 0.0) return (1.0 / range_m) * goal.offset_m;
  const double strength = std::clamp((range_m - config_.stand_off_m) / kEaseM, 0.0, 1.0);
  return (strength / range_m) * goal.offset_m;
}

}  // namespace tacit
