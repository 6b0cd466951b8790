#pragma once

#include <chrono>
#include <condition_variable>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <thread>

#include "console/gateway/server.h"
#include "console/live/live_run.h"
#include "console/server/run_list.h"

namespace tacit {

/// Finds runs that begin in a folder, whoever started them, and opens a session for each; a session
/// stays for a while after its run has ended, so that its last state can be looked at.
class LiveRuns {
 public:
  static constexpr std::chrono::milliseconds kLook{100};
  static constexpr std::chrono::seconds kAfterwards{600};

  /// Borrows both.
  LiveRuns(gateway::Server& server, const RunList& runs);
  ~LiveRuns();
  LiveRuns(const LiveRuns&) = delete;
  LiveRuns& operator=(const LiveRuns&) = delete;

  /// Says it to the run; false when it is not going on. From any thread.
  bool say(const std::string& id, const Control& control);
  /// Runs that go on. From any thread.
  [[nodiscard]] std::size_t count() const;

 private:
  using Clock = std::chrono::steady_clock;
  struct Entry {
    std::shared_ptr<LiveRun> run;  ///< Null once it is over.
    Clock::time_point over;
  };

  void run();
  void look();
  void look_at_sessions();
  void open(const std::string& id);

  gateway::Server& server_;
  const RunList& runs_;
  mutable std::mutex mutex_;
  std::condition_variable home_;
  bool going_home_ = false;
  std::map<std::string, Entry> entries_;
  std::thread thread_;
};

}  // namespace tacit
