#pragma once

#include "console/record/run_directory.h"
#include "deploy/tacit/run_plan.h"
#include "deploy/tacit/supervisor.h"

namespace tacit {

/// Makes the run as processes over DDS, on a domain of its own, and leaves nothing of it in shared
/// memory. Throws BusError when there is no free domain.
[[nodiscard]] Ending run_over_dds(const RunPlan& plan, const RunDirectory& directory,
                                  Signals& signals);

}  // namespace tacit
