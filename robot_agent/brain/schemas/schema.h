#pragma once

#include <cstdint>

#include "idl/types/frames.h"
#include "idl/types/ids.h"
#include "robot_agent/brain/perception/surroundings.h"

namespace tacit {

/// Who a brain is, for what depends on that.
struct Self {
  RobotId robot;
  std::uint64_t seed = 0;  ///< Of the run.
};

/// A primitive behaviour (Arkin's motor schema): where the robot's surroundings push or pull it.
class Schema {
 public:
  virtual ~Schema() = default;

  /// Its state has been entered anew: whatever it remembers begins with the next push.
  virtual void enter() {}

  /// The push before weighting, body frame, of the order of 1. A schema may remember: call once
  /// per tick, ticks ascending.
  [[nodiscard]] virtual BodyVec push(const Surroundings& around) = 0;
};

}  // namespace tacit
