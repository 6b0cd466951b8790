#pragma once

#include <optional>

#include "idl/types/frames.h"

namespace tacit {

/// Where the target is, also while it is out of sight.
class TargetMemory {
 public:
  /// `offset_m` is where the target is seen from the robot's pose `odometry`.
  void see(const OdometryPose& odometry, const BodyVec& offset_m);
  /// Where the target must be, seen from `odometry`; empty until it was first seen.
  [[nodiscard]] std::optional<BodyVec> from(const OdometryPose& odometry) const;

 private:
  std::optional<OdometryVec> place_m_;
};

}  // namespace tacit
