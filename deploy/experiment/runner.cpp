#include "deploy/experiment/runner.h"

#include <algorithm>
#include <chrono>
#include <exception>
#include <mutex>
#include <set>
#include <thread>
#include <utility>
#include <vector>

#include "deploy/experiment/chain.h"
#include "deploy/experiment/selection.h"
#include "deploy/lockstep/setup.h"
#include "idl/types/config_error.h"

namespace tacit {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

RunFacts facts(const Battery& battery, const PlannedRun& run, const Setup& setup) {
  return {run.key,
          battery.version(),
          setup.run.name,
          run.seed,
          "one-process",
          setup.world.robots.count,
          setup.brain.learner,
          strategy(setup),
          battery.command(battery.cells()[run.cell], run.seed),
          utc_now()};
}

/// The runs that are not there yet, each once: cells that come to the same scenario share them.
class Queue {
 public:
  Queue(const std::vector<PlannedRun>& runs, const RunStore& store) {
    const std::vector<std::string> finished = store.finished_keys();
    std::set<std::string> seen;
    for (const PlannedRun& run : runs) {
      if (!seen.insert(run.key).second) {
        ++doubled_;
      } else if (!std::binary_search(finished.begin(), finished.end(), run.key)) {
        open_.push_back(run);
      }
    }
    there_ = seen.size() - open_.size();
  }

  /// How many of the runs given are the same as another of them.
  [[nodiscard]] std::size_t doubled() const { return doubled_; }
  /// How many were there already.
  [[nodiscard]] std::size_t there() const { return there_; }
  [[nodiscard]] const PlannedRun* take() {
    return next_ == open_.size() ? nullptr : &open_[next_++];
  }

 private:
  std::vector<PlannedRun> open_;
  std::size_t next_ = 0;
  std::size_t there_ = 0;
  std::size_t doubled_ = 0;
};

/// One sitting at a battery: workers that take runs and keep what comes of them.
class Sitting {
 public:
  Sitting(const Battery& battery, RunStore& store, const RunnerOptions& options)
      : battery_(battery), store_(store), options_(options), start_(Clock::now()) {
    progress_.all = battery.runs().size() + held_out_count(battery);
  }

  /// True when all of `runs` are there. Throws what a worker threw.
  bool make(const std::vector<PlannedRun>& runs) {
    queue_ = Queue(runs, store_);
    progress_.all -= queue_.doubled();
    progress_.done += queue_.there();
    progress_.resumed += queue_.there();
    const std::size_t wanted = progress_.done - queue_.there() + runs.size() - queue_.doubled();
    report();
    std::vector<std::jthread> workers;
    for (unsigned i = 0; i < std::max(1U, options_.workers); ++i) {
      workers.emplace_back([this] { work(); });
    }
    workers.clear();
    if (failure_) {
      std::rethrow_exception(failure_);
    }
    return progress_.done == wanted;
  }

 private:
  void work() {
    while (const PlannedRun* run = take()) {
      try {
        if (const std::optional<RunRow> row = make_run(battery_, *run, options_.stop)) {
          keep(*row);
        }
      } catch (...) {
        const std::lock_guard lock(mutex_);
        failure_ = std::current_exception();
      }
    }
  }

  const PlannedRun* take() {
    const std::lock_guard lock(mutex_);
    const bool stopped = options_.stop != nullptr && options_.stop->load();
    return stopped || failure_ ? nullptr : queue_.take();
  }

  void keep(const RunRow& row) {
    const std::lock_guard lock(mutex_);
    store_.add(row);
    ++progress_.done;
    progress_.ticks += row.outcome.ticks;
    report();
  }

  void report() {
    progress_.wall_s = seconds_since(start_);
    if (options_.progress) {
      options_.progress(progress_);
    }
  }

  const Battery& battery_;
  RunStore& store_;
  const RunnerOptions& options_;
  Clock::time_point start_;
  std::mutex mutex_;
  Queue queue_{{}, store_};
  BatteryProgress progress_;
  std::exception_ptr failure_;
};

/// Throws ConfigError when a contest has no winner though all its runs are there.
void require_winners(const Battery& battery, std::size_t held_out) {
  if (held_out != held_out_count(battery)) {
    throw ConfigError("[experiment] select_by = \"" + battery.config().select_by +
                      "\", which no run of some scenario and team size has, wanted a metric of "
                      "the mission");
  }
}

}  // namespace

std::optional<RunRow> make_run(const Battery& battery, const PlannedRun& run,
                               const std::atomic<bool>* stop) {
  const Clock::time_point start = Clock::now();
  const std::string text = battery.scenario(battery.cells()[run.cell], run.seed);
  ScenarioFile file = ScenarioFile::parse(text, "resolved scenario");
  const Setup setup = read_setup(file);
  Chain chain(setup, {battery.config().episodes, evaluated(battery.config())});
  while (!chain.done()) {
    if (!chain.next([stop] { return stop != nullptr && stop->load(); })) {
      return std::nullopt;
    }
  }
  return RunRow{facts(battery, run, setup), chain.outcome(seconds_since(start)), ""};
}

bool run_battery(const Battery& battery, RunStore& store, const RunnerOptions& options) {
  Sitting sitting(battery, store, options);
  if (!sitting.make(battery.runs())) {
    return false;
  }
  if (battery.config().select_by.empty()) {
    return true;
  }
  const std::vector<PlannedRun> held_out = held_out_runs(battery, store);
  require_winners(battery, held_out.size());
  return sitting.make(held_out);
}

}  // namespace tacit
