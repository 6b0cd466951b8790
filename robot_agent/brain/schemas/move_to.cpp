#include "robot_agent/brain/schemas/move_to.h"

namespace tacit {

BodyVec MoveTo::push(const Surroundings& around) {
  const Nearest& goal = around.nearest_of(thing_);
  if (!goal.known() || goal.squared_range_m2 == 0.0) return {};
  return (1.0 / std::sqrt(goal.squared_range_m2)) * goal.offset_m;
}

}  // namespace tacit
