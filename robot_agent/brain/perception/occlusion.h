#pragma once

#include <cstddef>
#include <span>

#include "idl/types/parameters.h"
#include "robot_agent/brain/perception/surroundings.h"

namespace tacit {

/// Tells which teammates have taken a group of enemies on.
///
/// An able teammate intercepts a group, and occludes it, when it is nearer to the group's centroid
/// than this robot and within an angle of the line of sight to it.
class Occlusion {
 public:
  struct Config {
    double angle_deg = 15.0;  ///< To either side of the line of sight, 0 to 180.
  };
  explicit Occlusion(const Config& config);

  /// Whether any of `teammates` occludes the group whose centroid is at `group_m`.
  [[nodiscard]] bool occluded(const BodyVec& group_m, std::span<const Seen> teammates) const;
  /// How many do.
  [[nodiscard]] std::size_t interceptors(const BodyVec& group_m,
                                         std::span<const Seen> teammates) const;

 private:
  double cos_angle_;
};

void describe(Occlusion::Config& config, ParameterVisitor& visitor);

}  // namespace tacit
