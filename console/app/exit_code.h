#pragma once

namespace tacit {

/// How the console ends, as docs/run-directory.md has it.
enum class ExitCode : int {
  Done = 0,
  NotRecorded = 1,
  BadInput = 2,
  WorldVanished = 4,
  Interrupted = 130,
};

}  // namespace tacit
