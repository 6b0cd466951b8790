#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "console/record/run.h"
#include "console/report/table.h"
#include "deploy/experiment/chain.h"

namespace tacit {

/// "run 7/30  seed 7  1,423 ticks  accomplished  mines 20/20  ETA 3:05". `elapsed_s` is the wall
/// time of the runs so far.
[[nodiscard]] std::string episode_text(const Episode& episode, std::int64_t episodes,
                                       double elapsed_s);

/// Every run with its score, a row each.
[[nodiscard]] Table episodes_table(std::span<const Episode> episodes);

/// The mean scores of the first and the last `evaluate` runs, and how many of them failed.
[[nodiscard]] Table learned_table(std::span<const Episode> episodes, std::int64_t evaluate);

/// The whole chain as one JSON object; `policy_dir` may be empty.
[[nodiscard]] std::string learned_json(const RunFacts& facts, const ChainLength& length,
                                       const RunOutcome& outcome, const std::string& policy_dir);

}  // namespace tacit
