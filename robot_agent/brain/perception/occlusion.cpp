#include "robot_agent/brain/perception/occlusion.h"

#include <algorithm>

namespace tacit {
namespace {

struct LineOfSight {
  BodyVec group_m;
  double least_cos_m;  ///< Cosine of the angle times the length of the line.

  [[nodiscard]] bool held_by(const Seen& mate) const {
    const double dot_m2 = mate.offset_m.dot(group_m);
    // |group - mate| < |group|, with the squares multiplied out.
    const bool nearer_to_group = mate.range_m * mate.range_m < 2.0 * dot_m2;
    return mate.able && nearer_to_group && dot_m2 >= least_cos_m * mate.range_m;
  }
};

}  // namespace

Occlusion::Occlusion(const Config& config)
    : cos_angle_(sin_cos(config.angle_deg * kPi / 180.0).cos) {}

bool Occlusion::occluded(const BodyVec& group_m, std::span<const Seen> teammates) const {
  const LineOfSight line{group_m, cos_angle_ * group_m.norm()};
  return std::any_of(teammates.begin(), teammates.end(),
                     [&line](const Seen& mate) { return line.held_by(mate); });
}

std::size_t Occlusion::interceptors(const BodyVec& group_m, std::span<const Seen> teammates) const {
  const LineOfSight line{group_m, cos_angle_ * group_m.norm()};
  return static_cast<std::size_t>(
      std::count_if(teammates.begin(), teammates.end(),
                    [&line](const Seen& mate) { return line.held_by(mate); }));
}

void describe(Occlusion::Config& config, ParameterVisitor& visitor) {
  visitor.section("brain.occlusion", "Which teammates have taken a group of enemies on.");
  visitor.number("angle_deg", config.angle_deg, {0.0, 180.0},
                 {"deg",
                  "A nearer teammate this close to the line of sight occludes a group [ours: the "
                  "paper names occlusion without an angle]."});
}

}  // namespace tacit
