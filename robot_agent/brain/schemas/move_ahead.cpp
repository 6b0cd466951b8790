#include "robot_agent/brain/schemas/move_ahead.h"

namespace tacit {

BodyVec MoveAhead::push(const Surroundings& around) {
  if (!way_) {
    const SinCos turn = sin_cos(config_.turned_deg * kPi / 180.0);
    way_ = from_body<OdometryFrame>(around.odometry.heading, BodyVec{turn.cos, turn.sin});
  }
  return to_body(around.odometry.heading, *way_);
}

}  // namespace tacit
