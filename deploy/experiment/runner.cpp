#include "deploy/experiment/runner.h"

#include <algorithm>
#include <chrono>
#include <exception>
#include <mutex>
#include <thread>
#include <utility>
#include <vector>

#include "console/metrics/tally.h"
#include "console/record/sha256.h"
#include "deploy/lockstep/setup.h"
#include "deploy/lockstep/team.h"

namespace tacit {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

/// What a run directory's event log and metrics would hold, without the directory.
class Account {
 public:
  void add(std::span<const Event> events) {
    for (const Event& event : events) {
      line_ = to_line(event);
      line_ += '\n';
      log_.add(line_);
      tally_.add(event);
      ++events_;
    }
  }
  [[nodiscard]] RunOutcome outcome(double wall_s) const {
    RunOutcome outcome;
    outcome.complete = tally_.of<Length>().complete;
    outcome.repeatable = true;
    outcome.ticks = tally_.of<Length>().ticks;
    outcome.events = events_;
    outcome.wall_s = wall_s;
    outcome.event_log_sha256 = log_.hex();
    outcome.metrics = recorded(tally_);
    return outcome;
  }

 private:
  std::string line_;
  Sha256 log_;
  Tally tally_;
  std::uint64_t events_ = 0;
};

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

/// The runs that several workers take from and report to.
class Queue {
 public:
  Queue(const Battery& battery, RunStore& store, const RunnerOptions& options)
      : battery_(battery), store_(store), options_(options), start_(Clock::now()) {
    const std::vector<std::string> finished = store.finished_keys();
    for (const PlannedRun& run : battery.runs()) {
      if (!std::binary_search(finished.begin(), finished.end(), run.key)) {
        open_.push_back(&run);
      }
    }
    progress_.all = battery.runs().size();
    progress_.done = progress_.resumed = progress_.all - open_.size();
  }

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

  /// True when nothing is left to be done. Throws what a worker threw.
  bool finish() {
    if (failure_) {
      std::rethrow_exception(failure_);
    }
    return progress_.done == progress_.all;
  }

  void tell() {
    const std::lock_guard lock(mutex_);
    report();
  }

 private:
  const PlannedRun* take() {
    const std::lock_guard lock(mutex_);
    const bool stopped = options_.stop != nullptr && options_.stop->load();
    return stopped || failure_ || next_ == open_.size() ? nullptr : open_[next_++];
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
  std::vector<const PlannedRun*> open_;
  std::size_t next_ = 0;
  BatteryProgress progress_;
  std::exception_ptr failure_;
};

}  // namespace

std::optional<RunRow> make_run(const Battery& battery, const PlannedRun& run,
                               const std::atomic<bool>* stop) {
  constexpr Tick kLook = 1024;
  const Clock::time_point start = Clock::now();
  const std::string text = battery.scenario(battery.cells()[run.cell], run.seed);
  ScenarioFile file = ScenarioFile::parse(text, "resolved scenario");
  const Setup setup = read_setup(file);
  Team team(setup.world, setup.brain, seed(setup));
  Account account;
  for (const Tick last = last_tick(setup); team.tick() < last;) {
    if (team.tick() % kLook == 0 && stop != nullptr && stop->load()) {
      return std::nullopt;
    }
    account.add(team.step());
  }
  const Event ending = team.ending();
  account.add({&ending, 1});
  return RunRow{facts(battery, run, setup), account.outcome(seconds_since(start)), ""};
}

bool run_battery(const Battery& battery, RunStore& store, const RunnerOptions& options) {
  Queue queue(battery, store, options);
  queue.tell();
  std::vector<std::jthread> workers;
  for (unsigned i = 0; i < std::max(1U, options.workers); ++i) {
    workers.emplace_back([&queue] { queue.work(); });
  }
  workers.clear();
  return queue.finish();
}

}  // namespace tacit
