#pragma once

#include <chrono>
#include <deque>
#include <optional>
#include <string>
#include <vector>

#include "deploy/tacit/cast.h"
#include "deploy/tacit/child.h"
#include "deploy/tacit/exit_codes.h"
#include "deploy/tacit/signals.h"

namespace tacit {

/// How a run ended, in a word and in a sentence.
struct Ending {
  Exit exit = Exit::Done;
  std::string because;  ///< Empty when done.
};

/// How often a program may be started again before it counts as lost.
class RestartBudget {
 public:
  using Time = std::chrono::steady_clock::time_point;
  static constexpr std::size_t kRestarts = 5;
  static constexpr std::chrono::seconds kPeriod{60};

  /// Whether one more start at `now` is within the budget; if so, it counts.
  [[nodiscard]] bool spend(Time now);

 private:
  std::deque<Time> spent_;
};

/// Runs a cast to its end: starts all, starts an agent or a console that dies again, and ends all
/// within two seconds when asked to, when the world is lost, or when the time is out.
class Supervisor {
 public:
  /// `timeout` of zero: none.
  Supervisor(const Cast& cast, Signals& signals, std::chrono::duration<double> timeout);

  /// Throws std::system_error when a program cannot be started; then none runs.
  [[nodiscard]] Ending run();

 private:
  using Clock = std::chrono::steady_clock;

  /// One program of the cast and its process.
  struct Member {
    const Program* program;
    std::optional<Child> child;
    RestartBudget budget;
    std::optional<Clock::time_point> restart_at;
  };

  void start_all();
  [[nodiscard]] Ending watch();
  void note_deaths();
  void note_death_of_world(const Death& death);
  void note_death_of_console(const Death& death);
  void note_death_of_agent(Member& agent, const Death& death);
  void restart_due();
  void restart(Member& member);
  void check_time();
  [[nodiscard]] bool all_gone() const;
  void stop_all();
  void send_all(int signal);
  void end(Exit exit, std::string because);

  Signals& signals_;
  std::optional<Clock::time_point> deadline_;
  Member world_;
  Member console_;
  std::vector<Member> agents_;
  std::optional<Clock::time_point> world_done_;
  bool stopped_ = false;                           ///< By a control word.
  std::optional<Clock::time_point> console_left_;  ///< When a signal or such a word ended it.
  std::optional<Ending> ending_;
};

}  // namespace tacit
