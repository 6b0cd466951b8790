#pragma once

#include <mutex>
#include <optional>

#include "idl/bus/bell.h"
#include "idl/bus/publisher.h"
#include "idl/bus/stop_signals.h"
#include "idl/bus/subscriber.h"
#include "robot_agent/app/answers.h"
#include "robot_agent/app/exit_code.h"
#include "robot_agent/app/notes.h"
#include "robot_agent/app/soldier.h"

namespace tacit {

/// A brain at its post: answers percepts until the run is over.
///
/// A percept is answered by the thread of the bus that brings it: in lock-step there is nothing
/// else for that thread to do, and handing it over to another would cost a third of the tick. A
/// lock keeps thought to one thread at a time.
class Agent {
 public:
  struct Settings {
    RobotId robot;
    int domain = 1;
    std::uint32_t run_nonce = 0;
    std::filesystem::path memory;   ///< Keeps where the brain stands, should this process die.
    std::filesystem::path inherit;  ///< What an earlier run taught; empty: nothing.
    std::filesystem::path learned;  ///< Keeps what is learned for later runs; empty: nowhere.
    std::chrono::duration<double> patience{30.0};  ///< Without a world server.
  };

  /// Throws ConfigError, BusError.
  Agent(const Soldier& soldier, const Settings& settings);

  /// Serves from hello to finish.
  [[nodiscard]] ExitCode run();

 private:
  using Time = Bell::Clock::time_point;

  void say_hello(const Soldier& soldier);
  void answer(const Percept& percept);
  void obey(const Order& order);
  /// Says how the agent ends, if it does.
  std::optional<ExitCode> see_to_the_rest(Time now);
  void tell_telemetry(Time now);
  void keep_memory(Time now);
  void keep_lessons();
  void begin();

  Settings settings_;
  std::uint64_t incarnation_;
  Brain brain_;
  Answers answers_;
  Notes notes_;
  std::uint64_t lessons_kept_ = 0;
  Bell bell_;
  StopSignals signals_;
  std::mutex thought_;  ///< Guards what follows that is not the bus's own.
  bool welcome_ = false;
  std::optional<ExitCode> ending_;
  Telemetry telemetry_;
  Time next_telemetry_{};
  Time last_sign_of_world_;
  Participant participant_;
  Publisher<topics::Command> commands_out_;
  Publisher<topics::Telemetry> telemetry_out_;
  Publisher<topics::Hello> hello_out_;
  Subscriber<topics::Percept> percepts_in_;
  Subscriber<topics::Order> orders_in_;
};

}  // namespace tacit
