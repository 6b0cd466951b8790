#include "robot_agent/app/agent.h"

#include <spdlog/spdlog.h>
#include <unistd.h>

#include <random>

#include "idl/bus/host_name.h"
#include "idl/version/version.h"

namespace tacit {
namespace {

using std::chrono::milliseconds;
using Clock = Bell::Clock;

constexpr milliseconds kTelemetryPeriod{100};
/// How often an agent looks up from its percepts.
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
      memory_(settings.memory),
      signals_(bell_),
      percepts_(bell_),
      orders_(bell_),
      participant_({Party::Agent, settings.robot, settings.domain, settings.run_nonce,
                    static_cast<std::uint32_t>(incarnation_)}),
      commands_out_(participant_, settings.robot),
      telemetry_out_(participant_, settings.robot),
      hello_out_(participant_),
      percepts_in_(participant_, settings.robot, percepts_),
      orders_in_(participant_, settings.robot, orders_),
      last_sign_of_world_(Clock::now()) {
  recall();
  say_hello(soldier);
}

ExitCode Agent::run() {
  while (!ending_) {
    bell_.wait_until(next_round_);
    answer_percepts();
    const Time now = Clock::now();
    if (now >= next_round_ || !welcome_) see_to_the_rest(now);
  }
  if (answers_.decisions() > 0) memory_.save(brain_.memory(), Clock::now());
  return *ending_;
}

void Agent::say_hello(const Soldier& soldier) {
  hello_out_.publish({settings_.robot, incarnation_, getpid(), host_name(), std::string(version()),
                      soldier.brain.learner, "sim", soldier.digest});
}

/// Before the welcome another agent may have this robot, so percepts are not for us.
void Agent::answer_percepts() {
  for (const Percept& percept : percepts_.collect()) {
    if (!welcome_) read_orders();
    if (!welcome_) continue;
    if (const Command* command = answers_.to(percept)) commands_out_.publish(*command);
  }
}

void Agent::see_to_the_rest(Time now) {
  next_round_ = now + kRound;
  read_orders();
  if (StopSignals::came() && !ending_) ending_ = ExitCode::Interrupted;
  if (answers_.decisions() > 0) {
    tell_telemetry(now);
    if (memory_.due(now)) memory_.save(brain_.memory(), now);
  }
  if (orders_in_.writers() > 0) last_sign_of_world_ = now;
  if (now - last_sign_of_world_ > settings_.patience && !ending_) {
    spdlog::error("robot {}: no world server for {} s on domain {}", settings_.robot.value,
                  settings_.patience.count(), settings_.domain);
    ending_ = ExitCode::TimedOut;
  }
}

void Agent::read_orders() {
  for (const Order& order : orders_.collect()) {
    if (order.incarnation == incarnation_ || order.incarnation == 0) obey(order);
  }
}

void Agent::obey(const Order& order) {
  switch (order.kind) {
    case OrderKind::Welcome:
      welcome_ = true;
      return;
    case OrderKind::Refuse:
      spdlog::error("robot {}: refused by the world server: {}", settings_.robot.value,
                    order.reason);
      ending_ = ExitCode::BadInput;
      return;
    case OrderKind::Finish:
      ending_ = ExitCode::Done;
      return;
  }
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

void Agent::recall() {
  const std::optional<std::string> memory = memory_.load();
  if (memory && !brain_.recall(*memory)) {
    spdlog::warn("robot {}: {} is of another configuration; starting without it",
                 settings_.robot.value, settings_.memory.string());
  }
}

}  // namespace tacit
