#include "world_server/app/server.h"

#include <spdlog/spdlog.h>

#include <algorithm>

#include "idl/version/version.h"

namespace tacit {
namespace {

using std::chrono::milliseconds;
using Clock = Bell::Clock;

/// How soon the end of a process is noticed.
constexpr milliseconds kLookPeriod{20};
constexpr milliseconds kStatusPeriod{200};
/// While agents gather there is nothing to be late for.
constexpr milliseconds kGatherPeriod{2};
/// Those who read the event log may be slow, but a dead reader must not hold up the end.
constexpr milliseconds kLogPatience{10000};
constexpr milliseconds kShortPatience{250};

double seconds(Clock::duration duration) { return std::chrono::duration<double>(duration).count(); }

}  // namespace

Server::Server(const Mission& mission, const Settings& settings)
    : settings_(settings),
      last_tick_(mission.last_tick),
      launched_(Clock::now()),
      world_(mission.world, mission.seed),
      signals_(bell_),
      hellos_(bell_),
      controls_(bell_),
      barrier_(world_.percepts().size(), [this] { carry_on(); }),
      participant_(settings.identity),
      lines_(participant_, world_.percepts().size(), barrier_),
      log_(participant_),
      gallery_(participant_, settings.view_hz, settings.trajectories),
      status_out_(participant_),
      hellos_in_(participant_, {}, hellos_),
      controls_in_(participant_, {}, controls_),
      attendance_({world_.percepts().size(), std::string(version()), mission.digest}, lines_),
      exchange_(lines_, barrier_),
      pace_(settings.speed, mission.world.physics.tick_s) {}

ExitCode Server::run() {
  if (const auto code = gather()) return close(*code);
  begun_ = Clock::now();
  if (const auto code = make_ticks()) return close(*code);
  const Event ended{world_.tick(), RunEnded{world_.digest()}};
  log_.add({&ended, 1});
  return close(ExitCode::Done);
}

std::optional<ExitCode> Server::gather() {
  const Time until = Clock::now() + std::chrono::duration_cast<Clock::duration>(settings_.gather);
  tell_status(RunPhase::Gathering);
  while (!is_everybody_here()) {
    if (stopped()) return ExitCode::Interrupted;
    if (Clock::now() >= until) {
      spdlog::error("after {} s there is still no {}", settings_.gather.count(), missing());
      return ExitCode::TimedOut;
    }
    sleep_until(Clock::now() + kGatherPeriod);
    tell_status_now_and_then();
  }
  return {};
}

std::optional<ExitCode> Server::make_ticks() {
  tell_status(RunPhase::Running);
  while (!done()) {
    wait_for_turn();
    if (attendance_.count() == 0) {
      if (const auto code = wait_for_anybody()) return code;
    }
    if (stopped()) return ExitCode::Interrupted;
    make_ticks_in_turn();
  }
  return {};
}

/// Without any agent the run would be over in a moment and mean nothing.
std::optional<ExitCode> Server::wait_for_anybody() {
  const Time until = Clock::now() + std::chrono::duration_cast<Clock::duration>(settings_.gather);
  spdlog::warn("tick {}: no agent is left; waiting for one to come back", world_.tick());
  while (attendance_.count() == 0 && !stopped()) {
    if (Clock::now() >= until) {
      spdlog::error("tick {}: every agent is gone and none came back within {} s", world_.tick(),
                    settings_.gather.count());
      return ExitCode::AgentLost;
    }
    sleep_until(Clock::now() + kGatherPeriod);
    tell_status_now_and_then();
  }
  return {};
}

void Server::wait_for_turn() {
  for (;;) {
    const Time now = Clock::now();
    const std::optional<Time> turn = pace_.next_tick_at(now);
    if (stopped()) return;
    if (turn && *turn <= now) return pace_.began(now);
    sleep_until(std::min(turn.value_or(now + kLookPeriod), now + kLookPeriod));
    tell_status_now_and_then();
  }
}

/// Begins a tick, and returns when no tick is under way any more.
void Server::make_ticks_in_turn() {
  std::unique_lock baton(baton_);
  begin_tick(Clock::now());
  while (in_tick_ && !stopped()) {
    const Time until = std::min(exchange_.resend_at(), late_at_.value_or(Time::max()));
    baton.unlock();
    bell_.wait_until(std::min(until, Clock::now() + kLookPeriod));
    baton.lock();
    if (in_tick_) push_on(Clock::now());
  }
  in_tick_ = false;
  if (Clock::now() >= next_look_) look_around();
}

void Server::begin_tick(Time now) {
  in_tick_ = true;
  if (settings_.patience) late_at_ = now + *settings_.patience;
  exchange_.begin(world_.percepts(), attendance_.present(), now);
}

void Server::end_tick() {
  in_tick_ = false;
  log_.add(world_.step(exchange_.end()));
  gallery_.show(world_, attendance_.present(), Clock::now());
  tell_status_now_and_then();
}

/// Runs in the thread that brought the last command. What is not simply the next tick is left to
/// the main thread, as is a tick that it has the baton for.
void Server::carry_on() {
  const std::unique_lock baton(baton_, std::try_to_lock);
  if (!baton) return bell_.ring();
  while (in_tick_ && exchange_.complete() && !stopped()) {
    end_tick();
    const Time now = Clock::now();
    if (!may_go_on(now)) return bell_.ring();
    pace_.began(now);
    begin_tick(now);
  }
}

bool Server::may_go_on(Time now) const {
  const std::optional<Time> turn = pace_.next_tick_at(now);
  return turn && *turn <= now && now < next_look_ && !done() && attendance_.count() > 0;
}

/// Helps a tick that has not ended by itself.
void Server::push_on(Time now) {
  if (!exchange_.complete()) {
    look_around();
    if (late_at_ && now >= *late_at_) {
      leave_out_the_late();
      return end_tick();
    }
    exchange_.resend_if_due(now);
  }
  if (exchange_.complete()) end_tick();
}

void Server::leave_out_the_late() {
  std::vector<Happening> late;
  for (const RobotId robot : barrier_.missing()) {
    barrier_.excuse(robot);
    late.emplace_back(RobotLate{robot});
  }
  note(late);
}

/// Tells everybody how it ended and lets the agents go.
ExitCode Server::close(ExitCode code) {
  const bool done = code == ExitCode::Done;
  tell_status(done ? RunPhase::Ended : RunPhase::Stopped);
  const milliseconds patience = done ? kLogPatience : kShortPatience;
  if (!log_.wait_received(patience) || !gallery_.wait_received(patience) ||
      !status_out_.wait_received(kShortPatience)) {
    spdlog::warn("who records this run has not received all of it");
  }
  for (const Percept& percept : world_.percepts()) {
    lines_.send(Order{percept.robot, 0, OrderKind::Finish, done ? "the run is over" : "stopped"});
  }
  lines_.flush(kShortPatience);
  return code;
}

/// Sleeps until then or until something came, and sees to it.
void Server::sleep_until(Time until) {
  bell_.wait_until(std::min(until, Clock::now() + kLookPeriod));
  look_around();
}

void Server::look_around() {
  next_look_ = Clock::now() + kLookPeriod;
  read_mail();
  note(attendance_.look());
}

void Server::read_mail() {
  for (const Hello& hello : hellos_.collect()) note(attendance_.hear(hello));
  for (const Control& control : controls_.collect()) {
    pace_.hear(control);
    // What a person does is in no scenario, so the run cannot be made again from one.
    if (world_.operate(control)) status_.repeatable = false;
    if (begun_) tell_status(phase());
  }
}

/// What happens to the team before the first tick is no event of the run.
void Server::note(const std::vector<Happening>& changes) {
  if (!begun_ || changes.empty()) return;
  std::vector<Event> events;
  for (const Happening& change : changes) {
    events.push_back({world_.tick(), change});
    if (!std::holds_alternative<RobotLate>(change)) spdlog::warn("{}", to_line(events.back()));
    if (const auto* lost = std::get_if<RobotLost>(&change)) barrier_.excuse(lost->robot);
  }
  log_.add(events);
  status_.repeatable = false;
  tell_status(phase());
}

void Server::tell_status(RunPhase phase) {
  const Time now = Clock::now();
  status_.phase = phase;
  status_.tick = world_.tick();
  status_.last_tick = last_tick_;
  status_.events = log_.size();
  status_.wall_s = begun_ ? seconds(now - *begun_) : 0.0;
  status_.first_tick_s = begun_ ? seconds(*begun_ - launched_) : 0.0;
  status_.resent = exchange_.resent();
  status_.rejected = static_cast<std::uint32_t>(participant_.rejections().count());
  status_.robots = static_cast<std::uint16_t>(attendance_.present().size());
  status_.present = static_cast<std::uint16_t>(attendance_.count());
  status_out_.publish(status_);
  next_status_ = now + kStatusPeriod;
}

void Server::tell_status_now_and_then() {
  if (Clock::now() >= next_status_) tell_status(begun_ ? phase() : RunPhase::Gathering);
}

RunPhase Server::phase() const { return pace_.paused() ? RunPhase::Paused : RunPhase::Running; }

std::string Server::missing() const {
  return attendance_.complete() ? "console to record the run"
                                : "agent for robot " + attendance_.absent();
}

bool Server::is_everybody_here() const {
  return attendance_.complete() &&
         (!settings_.await_console || (log_.readers() > 0 && gallery_.has_recorder()));
}

}  // namespace tacit
