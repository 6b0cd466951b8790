#pragma once

#include <optional>
#include <string>
#include <vector>

#include "console/debrief/checklist.h"
#include "console/record/run_directory.h"
#include "deploy/tacit/exit_codes.h"
#include "deploy/tacit/run_plan.h"
#include "deploy/tacit/signals.h"

namespace tacit {

/// A run that has ended.
struct MadeRun {
  RunDirectory directory;
  Exit exit = Exit::Done;
  std::optional<Checklist> checklist;  ///< Of an operation that has a result.
};

/// Makes the run that is wished for, over DDS or in one process, and tells people of it: progress
/// and why it ended on standard error, the result on standard output. Throws as `plan` and
/// `make_directory` do.
MadeRun make_run(RunWish wish, Signals& signals);

/// The command line of this process.
[[nodiscard]] std::vector<std::string> words_typed();

}  // namespace tacit
