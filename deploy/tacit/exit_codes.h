#pragma once

namespace tacit {

/// How `tacit` ends. The numbers are part of the command line's interface.
enum class Exit : int {
  Done = 0,
  Unforeseen = 1,  ///< The machine failed: a full disk, no free domain, …
  BadInput = 2,    ///< Said before tick 0.
  Lost = 3,        ///< An agent could not be restarted, or the world was lost.
  TimedOut = 4,
  HashesDiffer = 5,
  Interrupted = 130,
};

}  // namespace tacit
