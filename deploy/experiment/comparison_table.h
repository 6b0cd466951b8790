#pragma once

#include "console/report/table.h"
#include "deploy/experiment/results.h"

namespace tacit {

/// Differences of every measure between the values of one factor, run by run on the same seed, with
/// Holm's correction over the table.
[[nodiscard]] Table comparison_table(const Battery& battery, const Results& results,
                                     const Factor& factor);

}  // namespace tacit
