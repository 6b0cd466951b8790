#pragma once

#include <cstdint>
#include <string>

#include "idl/types/frames.h"
#include "idl/types/ids.h"

namespace tacit {

/// An agent process introduces itself. `incarnation` differs between two processes that claim the
/// same robot, also after a restart.
struct Hello {
  RobotId robot;
  std::uint64_t incarnation = 0;
  std::int32_t pid = 0;
  std::string host;             ///< Host name, so that `pid` can be told from another machine's.
  std::string version;          ///< Of the agent's program.
  std::string learner;          ///< As configured.
  std::string driver;           ///< "sim", …
  std::string scenario_digest;  ///< SHA-256 of the resolved scenario the agent read.
};

/// The world server's word to one agent.
enum class OrderKind : std::uint8_t {
  Welcome,  ///< You are on the roster; percepts will come.
  Refuse,   ///< You are not; `reason` says why. Exit.
  Finish,   ///< The run is over. Exit.
};

struct Order {
  RobotId robot;
  std::uint64_t incarnation = 0;  ///< The process meant; 0 means any.
  OrderKind kind = OrderKind::Welcome;
  std::string reason;
};

/// A person's or supervisor's word to the world server.
enum class ControlKind : std::uint8_t {
  Pause,
  Resume,
  Step,      ///< While paused: make `ticks` ticks.
  Speed,     ///< `speed` times real time; 0 means as fast as it goes.
  Stop,      ///< End the run now; what is recorded stays.
  Steer,     ///< In an operation: hold `robot`'s joystick towards `joystick`.
  LetGo,     ///< Let its joystick go.
  Proceed,   ///< Give it the word to go on.
  SkipGoal,  ///< Let it leave out the goal under way.
};

struct Control {
  ControlKind kind = ControlKind::Pause;
  std::uint32_t ticks = 1;
  double speed = 0.0;
  RobotId robot{};      ///< Whom an operator's word is for; 0 is the whole team.
  WorldVec joystick{};  ///< Length 0 to 1.
};

/// How a run stands, told by the world server whenever it changes and a few times a second.
enum class RunPhase : std::uint8_t { Gathering, Running, Paused, Ended, Stopped };

struct RunStatus {
  RunPhase phase = RunPhase::Gathering;
  Tick tick = 0;
  Tick last_tick = 0;         ///< The tick at which the run will end.
  std::uint64_t events = 0;   ///< Published so far, so that a reader knows what it still misses.
  double wall_s = 0.0;        ///< Since the first tick.
  double first_tick_s = 0.0;  ///< From the world server's launch to the first tick.
  std::uint32_t resent = 0;   ///< Percepts sent again because a command was late.
  std::uint32_t rejected = 0;
  std::uint16_t robots = 0;
  std::uint16_t present = 0;
  bool repeatable = true;  ///< False once a robot was lost or late, or an operator acted.
};

}  // namespace tacit
