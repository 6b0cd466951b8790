#pragma once

namespace tacit {

/// How a world server ends.
enum class ExitCode {
  Done = 0,
  Failed = 1,         ///< The bus or the machine would not do.
  BadInput = 2,       ///< Options or scenario.
  AgentLost = 3,      ///< Every agent is gone and none came back.
  TimedOut = 4,       ///< The agents did not all come.
  Interrupted = 130,  ///< By a signal or a control word.
};

}  // namespace tacit
