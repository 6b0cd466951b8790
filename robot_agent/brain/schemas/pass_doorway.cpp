#include "robot_agent/brain/schemas/pass_doorway.h"

#include <algorithm>
#include <limits>

namespace tacit {
namespace {

/// How far before a doorway a robot that comes at a slant turns to it [ours: a robot's length].
constexpr double kBeforeM = 0.5;

}  // namespace

const SeenDoorway* PassDoorway::pick(const Surroundings& around) const {
  const Premises& here = around.premises;
  BodyVec from;
  if (config_.leave && here.entrance) {
    from = to_body(around.odometry.heading, here.entrance->middle_m - around.odometry.position_m);
  }
  const SeenDoorway* best = nullptr;
  double best2 = std::numeric_limits<double>::infinity();
  for (const SeenDoorway& doorway : here.doorways) {
    if (config_.unmarked_only && doorway.marked) continue;
    const double range2 = (doorway.offset_m - from).squared_norm();
    if (range2 >= best2) continue;
    best = &doorway;
    best2 = range2;
  }
  return best;
}

std::optional<PassDoorway::Passage> PassDoorway::choose(const Surroundings& around) const {
  const SeenDoorway* doorway = pick(around);
  if (doorway == nullptr) return remembered(around.premises);
  const OdometryPose& own = around.odometry;
  Passage passage;
  passage.middle_m = own.position_m + from_body<OdometryFrame>(own.heading, doorway->offset_m);
  passage.half_width_m = doorway->jamb_m.norm();
  const BodyVec across = unit(BodyVec{-doorway->jamb_m.y(), doorway->jamb_m.x()});
  const OdometryVec one_way = from_body<OdometryFrame>(own.heading, across);
  passage.through = goes(one_way, *doorway, around) ? one_way : -one_way;
  return passage;
}

// In a large room the doorway may be out of sight.
std::optional<PassDoorway::Passage> PassDoorway::remembered(const Premises& here) const {
  constexpr double kNarrowM = 0.5;
  if (!config_.leave || !here.entrance) return std::nullopt;
  return Passage{here.entrance->middle_m, -here.entrance->inwards, 0.5 * kNarrowM};
}

// A robot that stands in the doorway cannot tell its sides by where it stands.
bool PassDoorway::goes(const OdometryVec& one_way, const SeenDoorway& doorway,
                       const Surroundings& around) const {
  const Premises& here = around.premises;
  const OdometryPose& own = around.odometry;
  const OdometryVec offset_m = from_body<OdometryFrame>(own.heading, doorway.offset_m);
  constexpr double kSamePlaceM = 0.5;
  if (here.entrance && (own.position_m + offset_m - here.entrance->middle_m).norm() < kSamePlaceM) {
    return (one_way.dot(here.entrance->inwards) > 0.0) != config_.leave;
  }
  if (here.hallway) {
    const OdometryVec to_centre_m = from_body<OdometryFrame>(own.heading, here.hallway->offset_m);
    // A hallway's centre line is on the other side of the doorway than the room.
    return (one_way.dot(offset_m - to_centre_m) > 0.0) != config_.leave;
  }
  return one_way.dot(offset_m) > 0.0;
}

BodyVec PassDoorway::push(const Surroundings& around) {
  if (!passage_) passage_ = choose(around);
  if (!passage_) return {};
  const OdometryVec from_middle_m = around.odometry.position_m - passage_->middle_m;
  const double past_m = from_middle_m.dot(passage_->through);
  const double aside_m = std::abs(from_middle_m.cross(passage_->through));
  // Beside the opening's middle third, and not yet in it: first to a place straight before it.
  const bool slanting = past_m < -0.1 && aside_m > passage_->half_width_m / 3.0;
  const double aim_m = slanting ? -kBeforeM : config_.beyond_m;
  const OdometryVec goal_m = passage_->middle_m + aim_m * passage_->through;
  return unit(to_body(around.odometry.heading, goal_m - around.odometry.position_m));
}

}  // namespace tacit
