#pragma once

#include "console/record/run_directory.h"
#include "deploy/tacit/run_plan.h"
#include "deploy/tacit/signals.h"
#include "deploy/tacit/supervisor.h"

namespace tacit {

/// Makes the run in this process, without DDS, and records it as the console does. Throws
/// RecordError.
[[nodiscard]] Ending run_in_one_process(const RunPlan& plan, const RunDirectory& directory,
                                        Signals& signals);

}  // namespace tacit
