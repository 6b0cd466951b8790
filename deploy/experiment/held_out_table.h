#pragma once

#include "console/record/run_store.h"
#include "console/report/table.h"
#include "deploy/experiment/battery.h"

namespace tacit {

/// What was selected against every rival, per scenario and team size, on seeds that played no part
/// in the selection: means of `select_by`, their paired difference (selected less rival) with
/// Cohen's d_z, and p of the paired t-test and of Wilcoxon's signed-rank test, each also after
/// Holm. The training mean is told beside them. Contests without a winner yet are left out.
[[nodiscard]] Table held_out_table(const Battery& battery, const RunStore& store);

}  // namespace tacit
