#pragma once

#include <cstdint>
#include <optional>

#include "idl/types/frames.h"
#include "idl/types/ids.h"
#include "idl/types/percept.h"
#include "idl/types/word.h"

namespace tacit {

/// What a robot does beside moving. It takes effect after the step's motion, on what is then in
/// reach.
enum class Act : std::uint8_t {
  None,
  PickUp,     ///< Take up the nearest mine or movable object in reach, unless it holds one.
  Drop,       ///< Put down what it holds; in the base or a container it is stored.
  Intercept,  ///< Destroy enemies in reach.
  Aid,        ///< Get disabled teammates in reach going again.
  Test,       ///< Find out whether the nearest object in reach is dangerous.
  Mark,       ///< Put a mark on the nearest doorway in reach.
  Unmark,     ///< Take it off.
  Signal,     ///< Say `word` aloud; who is near hears it.
  Alert,      ///< Tell the operator `word`.
  Finish,     ///< Nothing more to do: the robot's mission is over.
  FinishAll,  ///< The whole team's mission is over.
};

/// What a robot wants to do in answer to the percept of the same tick.
struct Command {
  RobotId robot;
  Tick tick = 0;
  BodyVec velocity_mps;     ///< Wanted velocity over ground, body frame.
  double turn_radps = 0.0;  ///< Wanted turn rate, counter-clockwise.
  Act act = Act::None;
  std::optional<Colour> about{};  ///< Of objects to pick up or test; any colour when empty.
  Word word{};                    ///< To signal or to alert with.
};

}  // namespace tacit
