#pragma once

#include <cstdint>

#include "idl/types/frames.h"
#include "idl/types/ids.h"

namespace tacit {

/// What a robot does beside moving. It takes effect after the step's motion, on what is then in
/// reach.
enum class Act : std::uint8_t {
  None,
  PickUp,     ///< Take up the nearest mine in reach, unless it holds one.
  Drop,       ///< Put down the mine that it holds; in the base it is stored.
  Intercept,  ///< Destroy enemies in reach.
  Aid,        ///< Get disabled teammates in reach going again.
};

/// What a robot wants to do in answer to the percept of the same tick.
struct Command {
  RobotId robot;
  Tick tick = 0;
  BodyVec velocity_mps;     ///< Wanted velocity over ground, body frame.
  double turn_radps = 0.0;  ///< Wanted turn rate, counter-clockwise.
  Act act = Act::None;
};

}  // namespace tacit
