#include "robot_agent/app/agent.h"

#include <spdlog/spdlog.h>
#include <unistd.h>

#include <random>

#include "idl/bus/host_name.h"
#include "idl/types/config_error.h"
#include "idl/version/version.h"

namespace tacit {
namespace {

using std::chrono::milliseconds;
using Clock = Bell::Clock;

constexpr milliseconds kTelemetryPeriod{100};
/// How often an agent sees to all that is not a percept.
constexpr milliseconds kRound{50};

std::uint64_t fresh_incarnation() {
  std::random_device chance;
  return (static_cast<std::uint64_t>(chance()) << 32 | chance()) | 1U;
}

}  // namespace

Agent::Agent(const Soldier& soldier, const Settings& settings)
    : settings_(settings),
      incarnation_(fresh_incarnation()),
      brain_(soldier.brain, settings.robot, soldier.seed),
      answers_([this](const Percept& percept) { return brain_.decide(percept); }),
      notes_(settings.memory, settings.learned),
      signals_(bell_),
      last_sign_of_world_(Clock::now()),
      participant_({Party::Agent, settings.robot, settings.domain, settings.run_nonce,
                    static_cast<std::uint32_t>(incarnation_)}),
      commands_out_(participant_, settings.robot),
      telemetry_out_(participant_, settings.robot),
      hello_out_(participant_),
      percepts_in_(participant_, settings.robot, [this](Percept& percept) { answer(percept); }),
      orders_in_(participant_, settings.robot, [this](Order& order) { obey(order); }) {
  begin();
  say_hello(soldier);
}

ExitCode Agent::run() {
  std::optional<ExitCode> ending;
  while (!ending) {
    bell_.wait_until(Clock::now() + kRound);
    ending = see_to_the_rest(Clock::now());
    if (ending || notes_.due(Clock::now())) keep_memory(Clock::now());
  }
  return *ending;
}

void Agent::say_hello(const Soldier& soldier) {
  hello_out_.publish({settings_.robot, incarnation_, getpid(), host_name(), std::string(version()),
                      soldier.brain.learner, "sim", soldier.digest});
}

/// Before the welcome another agent may have this robot, so percepts are not for us.
void Agent::answer(const Percept& percept) {
  const std::lock_guard lock(thought_);
  if (!welcome_ || ending_) return;
  const Command* command = answers_.to(percept);
  if (brain_.lessons() != lessons_kept_) keep_lessons();
  if (command != nullptr) commands_out_.publish(*command);
}

void Agent::obey(const Order& order) {
  const std::lock_guard lock(thought_);
  if (order.incarnation != incarnation_ && order.incarnation != 0) return;
  switch (order.kind) {
    case OrderKind::Welcome:
      welcome_ = true;
      return;
    case OrderKind::Refuse:
      spdlog::error("robot {}: refused by the world server: {}", settings_.robot.value,
                    order.reason);
      ending_ = ExitCode::BadInput;
      break;
    case OrderKind::Finish:
      ending_ = ExitCode::Done;
      break;
  }
  bell_.ring();
}

std::optional<ExitCode> Agent::see_to_the_rest(Time now) {
  const std::lock_guard lock(thought_);
  if (StopSignals::came() && !ending_) ending_ = ExitCode::Interrupted;
  if (answers_.decisions() > 0) tell_telemetry(now);
  if (orders_in_.writers() > 0) last_sign_of_world_ = now;
  if (now - last_sign_of_world_ > settings_.patience && !ending_) {
    spdlog::error("robot {}: no world server for {} s on domain {}", settings_.robot.value,
                  settings_.patience.count(), settings_.domain);
    ending_ = ExitCode::TimedOut;
  }
  return ending_;
}

void Agent::tell_telemetry(Time now) {
  if (now < next_telemetry_ || telemetry_out_.readers() == 0) return;
  next_telemetry_ = now + kTelemetryPeriod;
  brain_.report(telemetry_);
  telemetry_.decisions = answers_.decisions();
  telemetry_.duplicates = answers_.duplicates();
  telemetry_.rejected = participant_.rejections().count();
  telemetry_out_.publish(telemetry_);
}

/// The disk may be slow, so it is written to without the lock on thought; a lesson that is kept
/// meanwhile is the newer one and stays.
void Agent::keep_memory(Time now) {
  Note note;
  {
    const std::lock_guard lock(thought_);
    if (answers_.decisions() == 0 || !notes_.wanted()) return;
    note = note_of(brain_, answers_.decisions());
  }
  notes_.save(note, now);
}

/// A lesson is on disk before the world hears of the decision that it led to, so that at most the
/// one under way is lost with this process.
void Agent::keep_lessons() {
  lessons_kept_ = brain_.lessons();
  if (notes_.wanted()) notes_.save(note_of(brain_, answers_.decisions()), Clock::now());
}

/// Goes on where a forerunner of this run died, or else begins with what an earlier run taught.
void Agent::begin() {
  const std::optional<std::string> memory = notes_.load();
  if (memory && brain_.recall(*memory)) {
    lessons_kept_ = brain_.lessons();
    return;
  }
  if (memory) {
    spdlog::warn("robot {}: {} is of another configuration; starting without it",
                 settings_.robot.value, settings_.memory.string());
  }
  if (settings_.inherit.empty()) return;
  const std::optional<std::string> policy = MemoryFile(settings_.inherit).load();
  if (!policy) throw ConfigError(settings_.inherit.string() + ": cannot be read, wanted a policy");
  brain_.inherit(*policy, settings_.inherit.string());
}

}  // namespace tacit
