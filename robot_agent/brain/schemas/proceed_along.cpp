#include "robot_agent/brain/schemas/proceed_along.h"

namespace tacit {
namespace {

/// Facing less than this share along the hallway is facing across it: 60 degrees off and more.
constexpr double kAlong = 0.5;
/// So near to its end a hallway does not go on [ours: AtEndOfHall's tolerance].
constexpr double kAtItsEndM = 0.5;

/// The way of its course, unless the hallway ends there.
BodyVec by_course(const SeenHallway& hallway, const OdometryVec& course, const Heading& heading) {
  const bool ahead = to_body(heading, course).dot(hallway.along) >= 0.0;
  const bool ends = (ahead ? hallway.ahead_m : hallway.behind_m) <= kAtItsEndM;
  return ahead == ends ? -hallway.along : hallway.along;
}

}  // namespace

BodyVec ProceedAlong::choose(const SeenHallway& hallway, const Surroundings& around) const {
  const BodyVec& along = hallway.along;
  const BodyVec facing = along.x() < 0.0 ? -along : along;
  if (facing.x() >= kAlong) return facing;
  if (way_ == HallwayWay::Left) return along.y() < 0.0 ? -along : along;
  if (way_ == HallwayWay::Right) return along.y() > 0.0 ? -along : along;
  const auto& course = errand_->proceeded ? errand_->proceeded : around.premises.course;
  return course ? by_course(hallway, *course, around.odometry.heading) : facing;
}

BodyVec ProceedAlong::push(const Surroundings& around) {
  const auto& hallway = around.premises.hallway;
  if (!hallway) return {};
  const Heading& heading = around.odometry.heading;
  if (!chosen_) {
    chosen_ = from_body<OdometryFrame>(heading, choose(*hallway, around));
  }
  const BodyVec wanted = to_body(heading, *chosen_);
  const bool ahead = wanted.dot(hallway->along) >= 0.0;
  // The centre line bends, so what was chosen follows it.
  const BodyVec pull = ahead ? hallway->along : -hallway->along;
  chosen_ = from_body<OdometryFrame>(heading, pull);
  errand_->proceeded = chosen_;
  constexpr double kArrivedM = 0.05;
  return (ahead ? hallway->ahead_m : hallway->behind_m) > kArrivedM ? pull : BodyVec{};
}

}  // namespace tacit
