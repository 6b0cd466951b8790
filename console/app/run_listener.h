#pragma once

#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "idl/bus/bell.h"
#include "idl/bus/mailbox.h"
#include "idl/bus/participant.h"
#include "idl/bus/subscriber.h"

namespace tacit {

/// Hears all that a run tells the console. For one thread.
class RunListener {
 public:
  enum class Trajectories { Off, On };

  /// `bell` rings when something has come, and outlives the listener. Throws BusError.
  RunListener(const Identity& identity, std::int64_t robots, Trajectories trajectories, Bell& bell);

  /// What came since the last call, in order; each is valid until the next.
  [[nodiscard]] std::span<EventBatch> events() { return events_.collect(); }
  [[nodiscard]] std::span<WorldView> trajectories() { return trajectory_.collect(); }
  /// The newest, if one came since the last call.
  [[nodiscard]] std::optional<RunStatus> status();
  /// "4 ClearToEnemy, 2 AllClear": the robots by the role or situation each told last; empty when
  /// none has told one.
  [[nodiscard]] std::string doings();

 private:
  Mailbox<EventBatch> events_;
  Mailbox<WorldView> trajectory_;
  Mailbox<RunStatus> status_;
  Mailbox<Telemetry> telemetry_;
  std::map<RobotId, std::string> doing_;
  Participant participant_;
  Subscriber<topics::Events> events_in_;
  Subscriber<topics::Status> status_in_;
  std::optional<Subscriber<topics::Trajectory>> trajectory_in_;
  std::vector<Subscriber<topics::Telemetry>> telemetry_in_;
};

}  // namespace tacit
