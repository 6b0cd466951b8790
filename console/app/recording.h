#pragma once

#include <chrono>
#include <deque>
#include <string>
#include <utility>

#include "console/app/exit_code.h"
#include "console/app/run_listener.h"
#include "console/app/status_line.h"
#include "console/record/run_recorder.h"
#include "console/tape/live_tape.h"
#include "idl/types/roster.h"

namespace tacit {

/// How a recording came to its end.
struct Ending {
  ExitCode code = ExitCode::Done;
  std::string trouble;  ///< Why the run is not complete; empty when it is.
  double wall_s = 0.0;  ///< Of the run, as the world told it last.
};

/// Feeds a recorder and a tape with what a listener hears until the run is over, or the world has
/// vanished.
class Recording {
 public:
  struct Setting {
    bool trajectories = false;
    double tick_s = 0.1;
    std::chrono::duration<double> patience{20.0};
  };

  Recording(RunListener& listener, RunRecorder& recorder, LiveTape& tape, StatusLine& line,
            Setting setting);

  /// One round: takes what has come and shows how the run stands. The ending once there is one.
  [[nodiscard]] std::optional<Ending> round();

 private:
  using Clock = std::chrono::steady_clock;

  void take();
  [[nodiscard]] std::optional<Ending> ending();
  void hear(const RunStatus& status);
  [[nodiscard]] std::string standing();
  [[nodiscard]] bool all_viewed() const;
  [[nodiscard]] bool settled() const;
  [[nodiscard]] double ticks_per_s() const;

  RunListener& listener_;
  RunRecorder& recorder_;
  LiveTape& tape_;
  StatusLine& line_;
  Setting setting_;
  RunStatus status_;  ///< The newest.
  bool has_status_ = false;
  Clock::time_point heard_ = Clock::now();  ///< When the world was heard last.
  std::optional<Clock::time_point> ended_;  ///< When its last event had been taken.
  Tick newest_view_ = 0;
  std::deque<std::pair<double, Tick>> pace_;  ///< Wall time and tick of the last few seconds.
};

}  // namespace tacit
