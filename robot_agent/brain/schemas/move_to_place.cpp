#include "robot_agent/brain/schemas/move_to_place.h"

namespace tacit {

BodyVec MoveToPlace::push(const Surroundings& around) {
  constexpr double kOnTheSpotM = 1e-5;  // MissionLab's
  const WorldPose& own = around.premises.pose;
  const BodyVec offset_m = to_body(own.heading, goal_m_ - own.position_m);
  return offset_m.norm() > kOnTheSpotM ? unit(offset_m) : BodyVec{};
}

}  // namespace tacit
