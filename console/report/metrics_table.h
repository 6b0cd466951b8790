#pragma once

#include "console/metrics/tally.h"
#include "console/report/table.h"

namespace tacit {

/// What a run came to, a metric a row.
[[nodiscard]] Table metrics_table(const Tally& tally);

}  // namespace tacit
