#pragma once

namespace tacit {

/// How a robot's agent ends.
enum class ExitCode {
  Done = 0,           ///< The world server said that the run is over.
  Failed = 1,         ///< The bus or the machine would not do.
  BadInput = 2,       ///< Options or scenario, or the world server refused this agent.
  TimedOut = 4,       ///< No word of a world server.
  Interrupted = 130,  ///< By a signal.
};

}  // namespace tacit
