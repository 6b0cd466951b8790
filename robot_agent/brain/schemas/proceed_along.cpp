#include "robot_agent/brain/schemas/proceed_along.h"

namespace tacit {
namespace {

/// Facing less than this share along the hallway is facing across it: 45 degrees.
constexpr double kAlong = 0.7071;

BodyVec choose(HallwayWay way, const BodyVec& along, const Surroundings& around) {
  const BodyVec facing = along.x() < 0.0 ? -along : along;
  const bool across = facing.x() < kAlong;
  if (!across) return facing;
  if (way == HallwayWay::Left) return along.y() < 0.0 ? -along : along;
  if (way == HallwayWay::Right) return along.y() > 0.0 ? -along : along;
  if (!around.premises.course) return facing;
  const BodyVec course = to_body(around.odometry.heading, *around.premises.course);
  return course.dot(along) < 0.0 ? -along : along;
}

}  // namespace

BodyVec ProceedAlong::push(const Surroundings& around) {
  const auto& hallway = around.premises.hallway;
  if (!hallway) return {};
  const Heading& heading = around.odometry.heading;
  if (!chosen_) {
    chosen_ = from_body<OdometryFrame>(heading, choose(way_, hallway->along, around));
  }
  const BodyVec wanted = to_body(heading, *chosen_);
  const bool ahead = wanted.dot(hallway->along) >= 0.0;
  // The centre line bends, so what was chosen follows it.
  const BodyVec pull = ahead ? hallway->along : -hallway->along;
  chosen_ = from_body<OdometryFrame>(heading, pull);
  constexpr double kAtItsEndM = 0.05;
  return (ahead ? hallway->ahead_m : hallway->behind_m) > kAtItsEndM ? pull : BodyVec{};
}

}  // namespace tacit
