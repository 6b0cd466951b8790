#include "deploy/tacit/launch_bench.h"

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <optional>
#include <random>
#include <thread>

#include "console/record/temporary_folder.h"
#include "console/report/table.h"
#include "deploy/tacit/cast.h"
#include "deploy/tacit/say.h"
#include "deploy/tacit/signals.h"
#include "idl/bus/bell.h"
#include "idl/bus/domain_lease.h"
#include "idl/bus/leftovers.h"
#include "idl/bus/mailbox.h"
#include "idl/bus/subscriber.h"

namespace tacit {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

/// Proportional set size of a process in MB; absent when the kernel does not tell.
std::optional<double> pss_mb(pid_t pid) {
  std::ifstream in("/proc/" + std::to_string(pid) + "/smaps_rollup");
  for (std::string line; std::getline(in, line);) {
    if (line.starts_with("Pss:")) {
      return std::strtod(line.c_str() + 4, nullptr) / 1024.0;
    }
  }
  return std::nullopt;
}

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

/// The processes of a team that has been launched; ends them when it goes.
class Launch {
 public:
  explicit Launch(const Cast& cast) {
    children_.emplace_back(cast.world);
    children_.emplace_back(cast.console);
    for (const Program& agent : cast.agents) {
      children_.emplace_back(agent);
    }
  }
  ~Launch() {
    for (const Child& child : children_) {
      child.send(SIGTERM);
    }
    const Clock::time_point last_moment = Clock::now() + std::chrono::milliseconds(1500);
    while (Clock::now() < last_moment && any_running()) {
      std::this_thread::sleep_for(std::chrono::milliseconds(20));
    }
  }
  Launch(const Launch&) = delete;
  Launch& operator=(const Launch&) = delete;

  /// Of every agent.
  [[nodiscard]] std::vector<double> memory_mb() const {
    std::vector<double> sizes;
    for (std::size_t i = kOthers; i < children_.size(); ++i) {
      sizes.push_back(pss_mb(children_[i].pid()).value_or(0.0));
    }
    return sizes;
  }

 private:
  bool any_running() {
    bool running = false;
    for (Child& child : children_) {
      (void)child.reap();
      running = running || child.running();
    }
    return running;
  }

  static constexpr std::size_t kOthers = 2;  ///< Children that are no agents come first.
  std::vector<Child> children_;
};

/// Listens for the first tick of a run.
class FirstTick {
 public:
  explicit FirstTick(Venue venue)
      : participant_(Identity{Party::Launcher, {}, venue.domain, venue.run_nonce, 1}),
        status_in_(participant_, {}, status_) {}

  /// The world's own account of it; absent when it does not come in time.
  [[nodiscard]] std::optional<double> wait_s(std::chrono::seconds patience) {
    const Clock::time_point last_moment = Clock::now() + patience;
    while (Clock::now() < last_moment) {
      bell_.wait_until(Clock::now() + std::chrono::milliseconds(100));
      for (const RunStatus& status : status_.collect()) {
        if (status.tick > 0) {
          return status.first_tick_s;
        }
      }
    }
    return std::nullopt;
  }

 private:
  Bell bell_;
  Mailbox<RunStatus> status_{bell_};
  Participant participant_;
  Subscriber<topics::Status> status_in_;
};

RunPlan plan_for(std::int64_t robots, const fs::path& folder) {
  RunWish wish;
  wish.robots = std::to_string(robots);
  wish.duration_s = "1e6";
  wish.quiet = true;
  wish.out = (folder / ("run-" + std::to_string(robots))).string();
  return plan(std::move(wish));
}

/// A row of the table.
std::vector<TableCell> measure(std::int64_t robots, const fs::path& folder) {
  const RunPlan plan = plan_for(robots, folder);
  const RunDirectory directory = make_directory(plan);
  const std::uint32_t run_nonce = std::random_device{}();
  const DomainLease lease = DomainLease::take(run_nonce);
  const Venue venue{lease.domain(), run_nonce};
  std::vector<TableCell> row{robots, {}, {}, {}};
  {
    const Launch launch(cast_for(plan, directory, venue));
    FirstTick first_tick(venue);
    if (const auto seconds = first_tick.wait_s(std::chrono::seconds(60))) {
      std::this_thread::sleep_for(std::chrono::seconds(2));
      const std::vector<double> sizes = launch.memory_mb();
      row = {robots, *seconds, median(sizes), *std::max_element(sizes.begin(), sizes.end())};
    }
  }
  remove_leftovers(run_nonce);
  return row;
}

}  // namespace

Exit bench_launches() {
  Table table{"Launching a team",
              {{"robots", "robots", 0, false},
               {"first_tick_s", "launch to first tick, s", 2, false},
               {"median_pss_mb", "median PSS of an agent, MB", 1, false},
               {"largest_pss_mb", "largest, MB", 1, false}},
              {}};
  const TemporaryFolder folder("tacit-bench");
  Signals signals;
  for (const std::int64_t robots : {6, 12, 25, 50}) {
    say("measuring a team of " + std::to_string(robots));
    table.rows.push_back(measure(robots, folder.path()));
    signals.wait(std::chrono::milliseconds(0));
    if (signals.end_wanted()) {
      return Exit::Interrupted;
    }
  }
  std::cout << '\n' << to_text(table);
  return Exit::Done;
}

}  // namespace tacit
