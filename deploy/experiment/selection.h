#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "console/record/run_store.h"
#include "deploy/experiment/battery.h"

namespace tacit {

/// A scenario and a team size: the cells among which one is selected, and the rivals that it meets.
struct Contest {
  std::vector<std::size_t> candidates;
  std::vector<std::size_t> rivals;
};

/// Of an experiment with `select_by`, else none. In order of their first cells.
[[nodiscard]] std::vector<Contest> contests(const Battery& battery);

/// The candidate with the smallest mean of `select_by` over its runs on the seeds of training; of
/// equals the first. Absent while `store` lacks one of the candidates' runs, and when none of them
/// has the metric.
[[nodiscard]] std::optional<std::size_t> winner(const Battery& battery, const RunStore& store,
                                                const Contest& contest);

/// How many runs on held-out seeds the experiment has in all.
[[nodiscard]] std::size_t held_out_count(const Battery& battery);
/// Those whose cells are known by now: the winners' and the rivals', seed by seed.
[[nodiscard]] std::vector<PlannedRun> held_out_runs(const Battery& battery, const RunStore& store);

}  // namespace tacit
