#include "console/server/live_runs.h"

#include <spdlog/spdlog.h>

#include <algorithm>
#include <set>
#include <vector>

namespace tacit {

LiveRuns::LiveRuns(gateway::Server& server, const RunList& runs)
    : server_(server), runs_(runs), thread_([this] { run(); }) {}

LiveRuns::~LiveRuns() {
  {
    const std::lock_guard lock(mutex_);
    going_home_ = true;
  }
  home_.notify_one();
  thread_.join();
}

bool LiveRuns::say(const std::string& id, const Control& control) {
  std::shared_ptr<LiveRun> run;
  {
    const std::lock_guard lock(mutex_);
    const auto at = entries_.find(id);
    if (at != entries_.end()) run = at->second.run;
  }
  if (!run) return false;
  run->say(control);
  return true;
}

std::size_t LiveRuns::count() const {
  const std::lock_guard lock(mutex_);
  return static_cast<std::size_t>(
      std::count_if(entries_.begin(), entries_.end(),
                    [](const auto& entry) { return entry.second.run != nullptr; }));
}

void LiveRuns::run() {
  std::unique_lock lock(mutex_);
  while (!going_home_) {
    lock.unlock();
    look();
    lock.lock();
    home_.wait_for(lock, kLook, [this] { return going_home_; });
  }
}

void LiveRuns::look() {
  const std::vector<std::string> ids = runs_.live_ids();
  const std::set<std::string> live(ids.begin(), ids.end());
  const Clock::time_point now = Clock::now();
  std::vector<std::string> closed;
  std::vector<std::shared_ptr<LiveRun>> left;
  {
    const std::lock_guard lock(mutex_);
    for (auto& [id, entry] : entries_) {
      if (entry.run && !live.contains(id)) {
        left.push_back(std::move(entry.run));
        entry.run = nullptr;
        entry.over = now;
      } else if (!entry.run && now - entry.over > kAfterwards) {
        closed.push_back(id);
      }
    }
    for (const std::string& id : closed) entries_.erase(id);
  }
  for (const std::string& id : closed) server_.close_session(id);
  look_at_sessions();
  for (const std::string& id : live) open(id);
}

void LiveRuns::look_at_sessions() {
  std::vector<std::shared_ptr<LiveRun>> runs;
  {
    const std::lock_guard lock(mutex_);
    for (const auto& [id, entry] : entries_) {
      if (entry.run) runs.push_back(entry.run);
    }
  }
  for (const std::shared_ptr<LiveRun>& run : runs) {
    try {
      run->look();
    } catch (const std::exception& error) {
      spdlog::warn("a run cannot be watched: {}", error.what());
    }
  }
}

/// A run that cannot be watched yet is looked for again.
void LiveRuns::open(const std::string& id) {
  {
    const std::lock_guard lock(mutex_);
    const auto at = entries_.find(id);
    if (at != entries_.end() && at->second.run) return;
    if (at != entries_.end()) entries_.erase(at);
  }
  server_.close_session(id);
  try {
    const std::optional<LiveRunFacts> facts = runs_.live(id);
    if (!facts) return;
    auto run = std::make_shared<LiveRun>(server_.open_session(id, "Tacit " + id), *facts);
    const std::lock_guard lock(mutex_);
    entries_[id] = {std::move(run), {}};
  } catch (const std::exception& error) {
    server_.close_session(id);
    spdlog::warn("run {} cannot be watched: {}", id, error.what());
  }
}

}  // namespace tacit
