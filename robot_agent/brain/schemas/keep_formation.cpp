#include "robot_agent/brain/schemas/keep_formation.h"

#include <algorithm>

namespace tacit {

BodyVec unit_centre_m(const Premises& here) {
  BodyVec sum;
  for (const SeenObstacle& mate : here.friends) sum += mate.offset_m;
  return (1.0 / static_cast<double>(here.friends.size() + 1)) * sum;
}

BodyVec KeepFormation::push(const Surroundings& around) {
  const Premises& here = around.premises;
  const BodyVec centre_m = unit_centre_m(here);
  const BodyVec goal_m = to_body(here.pose.heading, config_.goal_m - here.pose.position_m);
  const BodyVec ahead = unit(goal_m - centre_m);
  const BodyVec left{-ahead.y(), ahead.x()};
  const BodyVec to_place_m = centre_m + config_.ahead_m * ahead + config_.left_m * left;
  const double off_m = to_place_m.norm() - config_.dead_zone_m;
  return std::clamp(off_m / config_.saturation_m, 0.0, 1.0) * unit(to_place_m);
}

}  // namespace tacit
