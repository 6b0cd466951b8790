#pragma once

#include <mutex>
#include <optional>
#include <vector>

#include "idl/bus/mailbox.h"
#include "idl/bus/stop_signals.h"
#include "world_server/app/attendance.h"
#include "world_server/app/event_log.h"
#include "world_server/app/exchange.h"
#include "world_server/app/exit_code.h"
#include "world_server/app/gallery.h"
#include "world_server/app/lines.h"
#include "world_server/app/mission.h"
#include "world_server/app/pace.h"
#include "world_server/world/world.h"

namespace tacit {

/// One run of a world with its agents, in lock-step.
///
/// The thread of the bus that brings a tick's last command moves the world on and sends the next
/// percepts; waking another thread for that would cost up to a third of the tick. The main thread
/// does all the rest and steps in when the run does not move by itself. Whoever touches the run
/// while a tick's words are under way has the baton.
class Server {
 public:
  struct Settings {
    Identity identity;
    double speed = 0.0;  ///< Times real time; 0: as fast as it goes.
    /// How long a tick waits for a command; none: without end.
    std::optional<std::chrono::milliseconds> patience;
    std::chrono::duration<double> gather{60.0};
    double view_hz = 20.0;
    Gallery::Trajectories trajectories = Gallery::Trajectories::Off;
    bool await_console = false;
  };

  /// Throws ConfigError when the scenario cannot be placed, BusError.
  Server(const Mission& mission, const Settings& settings);

  /// Makes the run, from the gathering of the agents to their dismissal.
  [[nodiscard]] ExitCode run();

 private:
  using Time = Bell::Clock::time_point;

  /// Each of these runs one part and says how the run ends, if it ends there.
  std::optional<ExitCode> gather();
  std::optional<ExitCode> make_ticks();
  std::optional<ExitCode> wait_for_anybody();
  void wait_for_turn();
  void make_ticks_in_turn();
  void begin_tick(Time now);
  void end_tick();
  void carry_on();
  void push_on(Time now);
  void leave_out_the_late();
  ExitCode close(ExitCode code);

  void sleep_until(Time until);
  void read_mail();
  void look_around();
  void note(const std::vector<Happening>& changes);
  void tell_status(RunPhase phase);
  void tell_status_now_and_then();
  [[nodiscard]] RunPhase phase() const;
  [[nodiscard]] bool may_go_on(Time now) const;
  [[nodiscard]] bool done() const { return world_.tick() >= last_tick_ || world_.over(); }
  [[nodiscard]] bool stopped() const { return StopSignals::came() || pace_.stopped(); }
  [[nodiscard]] bool is_everybody_here() const;
  [[nodiscard]] std::string missing() const;

  Settings settings_;
  std::mutex baton_;
  bool in_tick_ = false;  ///< Percepts are out and commands awaited.
  std::optional<Time> late_at_;
  Tick last_tick_;
  Time launched_;
  World world_;
  Bell bell_;
  StopSignals signals_;
  Mailbox<Hello> hellos_;
  Mailbox<Control> controls_;
  Barrier barrier_;
  Participant participant_;
  Lines lines_;
  EventLog log_;
  Gallery gallery_;
  Publisher<topics::Status> status_out_;
  Subscriber<topics::Hello> hellos_in_;
  Subscriber<topics::Control> controls_in_;
  Attendance attendance_;
  Exchange exchange_;
  Pace pace_;
  RunStatus status_;
  std::optional<Time> begun_;
  Time next_look_{};
  Time next_status_{};
};

}  // namespace tacit
