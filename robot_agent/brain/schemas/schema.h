#pragma once

#include <cstdint>
#include <memory>
#include <optional>

#include "idl/types/frames.h"
#include "idl/types/ids.h"
#include "robot_agent/brain/perception/surroundings.h"

namespace tacit {

/// What the behaviours of one robot remember for one another.
struct Errand {
  /// The way along a hallway in which it last meant to go, length 1.
  std::optional<OdometryVec> proceeded;
};

/// Who a brain is, for what depends on that.
struct Self {
  RobotId robot;
  std::uint64_t seed = 0;                    ///< Of the run.
  std::shared_ptr<Errand> errand = nullptr;  ///< Of an operation's robot.
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
