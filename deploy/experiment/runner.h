#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <optional>

#include "console/record/run_store.h"
#include "deploy/experiment/battery.h"

namespace tacit {

/// How far a battery has come. A chain of runs counts as one run; those on held-out seeds count
/// from the start.
struct BatteryProgress {
  std::size_t done = 0;     ///< Finished runs, those of earlier sittings included.
  std::size_t resumed = 0;  ///< Of these, finished before this sitting.
  std::size_t all = 0;
  std::uint64_t ticks = 0;  ///< Made in this sitting.
  double wall_s = 0.0;      ///< Of this sitting.
};

struct RunnerOptions {
  unsigned workers = 1;
  /// Called from worker threads, one at a time, after every run.
  std::function<void(const BatteryProgress&)> progress;
  /// Set from outside to end early; runs under way are given up.
  const std::atomic<bool>* stop = nullptr;
};

/// Makes one run, or chain of runs, in this process. Returns nothing when told to stop before its
/// end.
[[nodiscard]] std::optional<RunRow> make_run(const Battery& battery, const PlannedRun& run,
                                             const std::atomic<bool>* stop);

/// Makes all runs that `store` does not hold yet, each kept as soon as it is finished; where cells
/// are selected, first those of training, then those on held-out seeds. Returns true when all are
/// there. Throws RecordError when the store cannot be written, ConfigError when no run has the
/// metric to select by.
bool run_battery(const Battery& battery, RunStore& store, const RunnerOptions& options);

}  // namespace tacit
