#pragma once

#include <optional>

#include "idl/types/frames.h"

namespace tacit {

/// Where a thing that stays where it is lies (the target, the base), also while it is out of sight.
class PlaceMemory {
 public:
  /// `offset_m` is where the thing is seen from the robot's pose `odometry`.
  void see(const OdometryPose& odometry, const BodyVec& offset_m);
  /// Where the thing must be, seen from `odometry`; empty until it was first seen.
  [[nodiscard]] std::optional<BodyVec> from(const OdometryPose& odometry) const;

  /// The place itself, to be kept elsewhere and taken up again.
  [[nodiscard]] const std::optional<OdometryVec>& place_m() const { return place_m_; }
  void resume(const std::optional<OdometryVec>& place_m) { place_m_ = place_m; }

 private:
  std::optional<OdometryVec> place_m_;
};

}  // namespace tacit
