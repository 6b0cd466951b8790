#include "deploy/tacit/supervisor.h"

#include <csignal>
#include <utility>

#include "deploy/tacit/say.h"

namespace tacit {
namespace {

using namespace std::chrono_literals;

/// An agent that left in good order although the run goes on comes back after this.
constexpr auto kGrace = 3s;
/// The others have this long to finish once the world has.
constexpr auto kFarewell = 20s;
/// From SIGTERM to SIGKILL.
constexpr auto kMercy = 1500ms;
constexpr auto kGlance = 100ms;
/// What the programs end with when they were given something that cannot be.
constexpr int kBadInput = static_cast<int>(Exit::BadInput);
/// And when a control word or a signal ended the run.
constexpr int kInterrupted = static_cast<int>(Exit::Interrupted);

/// The world's exit codes for bad input and time-out mean the same as ours.
Exit exit_for(const Death& death_of_world) {
  const auto code = static_cast<Exit>(death_of_world.exit_code);
  return code == Exit::BadInput || code == Exit::TimedOut ? code : Exit::Lost;
}

std::string with_log(const std::string& text, const Program& program) {
  return text + (program.log.empty() ? "" : last_lines(program.log));
}

}  // namespace

bool RestartBudget::spend(Time now) {
  while (!spent_.empty() && now - spent_.front() > kPeriod) {
    spent_.pop_front();
  }
  if (spent_.size() >= kRestarts) {
    return false;
  }
  spent_.push_back(now);
  return true;
}

Supervisor::Supervisor(const Cast& cast, Signals& signals, std::chrono::duration<double> timeout)
    : signals_(signals), world_{&cast.world, {}, {}, {}}, console_{&cast.console, {}, {}, {}} {
  for (const Program& agent : cast.agents) {
    agents_.push_back({&agent, {}, {}, {}});
  }
  if (timeout.count() > 0) {
    deadline_ = Clock::now() + std::chrono::duration_cast<Clock::duration>(timeout);
  }
}

Ending Supervisor::run() {
  start_all();
  Ending ending = watch();
  stop_all();
  return ending;
}

void Supervisor::start_all() {
  world_.child.emplace(*world_.program);
  console_.child.emplace(*console_.program);
  for (Member& agent : agents_) {
    agent.child.emplace(*agent.program);
  }
}

Ending Supervisor::watch() {
  while (!ending_) {
    signals_.wait(kGlance);
    if (signals_.end_wanted()) {
      end(Exit::Interrupted, "interrupted");
    }
    note_deaths();
    restart_due();
    check_time();
    if (world_done_ && all_gone()) {
      end(stopped_ ? Exit::Interrupted : Exit::Done, stopped_ ? "stopped by its operator" : "");
    }
  }
  return *ending_;
}

void Supervisor::note_deaths() {
  if (const auto death = world_.child->reap()) {
    note_death_of_world(*death);
  }
  if (const auto death = console_.child->reap()) {
    note_death_of_console(*death);
  }
  for (Member& agent : agents_) {
    if (const auto death = agent.child->reap()) {
      note_death_of_agent(agent, *death);
    }
  }
}

void Supervisor::note_death_of_world(const Death& death) {
  stopped_ = death.exit_code == kInterrupted;
  if (death.well() || stopped_) {
    world_done_ = Clock::now();
    return;
  }
  end(exit_for(death), with_log("the world server " + death.words(), *world_.program));
}

void Supervisor::note_death_of_console(const Death& death) {
  if (death.well()) {
    return;
  }
  // A control word ends the world as well; without the console nothing would be recorded.
  if (death.exit_code == kInterrupted) {
    console_left_ = Clock::now();
    return;
  }
  // It says itself what it could not do; once more it could not either.
  if (death.signal == 0) {
    end(Exit::Unforeseen, "the console " + death.words());
    return;
  }
  say("the console " + death.words() + "; starting it again");
  restart(console_);
}

void Supervisor::note_death_of_agent(Member& agent, const Death& death) {
  if (world_done_) {
    if (!death.well()) {
      say(agent.program->name + " " + death.words() + " after the run");
    }
    return;
  }
  if (death.exit_code == kBadInput) {
    end(Exit::Lost, with_log(agent.program->name + " " + death.words(), *agent.program));
    return;
  }
  if (!death.well()) {
    say(agent.program->name + " " + death.words() + "; starting it again");
  }
  agent.restart_at = Clock::now() + (death.well() ? Clock::duration(kGrace) : Clock::duration(0));
}

void Supervisor::restart_due() {
  for (Member& agent : agents_) {
    if (agent.restart_at && !world_done_ && Clock::now() >= *agent.restart_at) {
      agent.restart_at.reset();
      restart(agent);
    }
  }
}

void Supervisor::restart(Member& member) {
  if (member.budget.spend(Clock::now())) {
    member.child.emplace(*member.program);
    return;
  }
  end(Exit::Lost, with_log(member.program->name + " died more than " +
                               std::to_string(RestartBudget::kRestarts) + " times in a minute",
                           *member.program));
}

void Supervisor::check_time() {
  if (deadline_ && Clock::now() >= *deadline_) {
    end(Exit::TimedOut, "the time is out");
  }
  if (console_left_ && !world_done_ && Clock::now() >= *console_left_ + kGrace) {
    end(Exit::Unforeseen, "the console was ended while the run goes on");
  }
  if (world_done_ && Clock::now() >= *world_done_ + kFarewell) {
    end(Exit::Unforeseen, "the run is over, but a program does not end");
  }
}

bool Supervisor::all_gone() const {
  for (const Member& agent : agents_) {
    if (agent.child->running()) {
      return false;
    }
  }
  return !world_.child->running() && !console_.child->running();
}

void Supervisor::stop_all() {
  const Clock::time_point last_moment = Clock::now() + kMercy;
  send_all(SIGTERM);
  while (!all_gone() && Clock::now() < last_moment) {
    signals_.wait(kGlance);
    for (Member& agent : agents_) {
      (void)agent.child->reap();
    }
    (void)world_.child->reap();
    (void)console_.child->reap();
  }
  send_all(SIGKILL);
}

void Supervisor::send_all(int signal) {
  world_.child->send(signal);
  console_.child->send(signal);
  for (const Member& agent : agents_) {
    agent.child->send(signal);
  }
}

void Supervisor::end(Exit exit, std::string because) {
  if (!ending_) {
    ending_ = Ending{exit, std::move(because)};
  }
}

}  // namespace tacit
