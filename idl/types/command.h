#pragma once

#include "idl/types/frames.h"
#include "idl/types/ids.h"

namespace tacit {

/// What a robot wants to do in answer to the percept of the same tick.
struct Command {
  RobotId robot;
  Tick tick = 0;
  BodyVec velocity_mps;     ///< Wanted velocity over ground, body frame.
  double turn_radps = 0.0;  ///< Wanted turn rate, counter-clockwise.
};

}  // namespace tacit
