#pragma once

#include "console/report/table.h"
#include "deploy/experiment/grouping.h"

namespace tacit {

/// Differences of the first measure between any two variants, over all runs that are alike but for
/// the variant; paired t-test and Cohen's d_z, p after Holm.
[[nodiscard]] Table variants_table(const Battery& battery, const Results& results);

/// How much of the variation of the first measure team size, variant and scenario account for by
/// themselves: an analysis of variance by main effects over all runs; whatever has one level is
/// left out.
[[nodiscard]] Table effects_table(const Battery& battery, const Results& results);

}  // namespace tacit
