#include "console/app/run_listener.h"

#include "console/report/progress_text.h"

namespace tacit {

RunListener::RunListener(const Identity& identity, std::int64_t robots, Trajectories trajectories,
                         Bell& bell)
    : events_(bell),
      trajectory_(bell),
      status_(bell),
      telemetry_(bell),
      participant_(identity),
      events_in_(participant_, RobotId{}, events_),
      status_in_(participant_, RobotId{}, status_) {
  if (trajectories == Trajectories::On) {
    trajectory_in_.emplace(participant_, RobotId{}, trajectory_);
  }
  for (std::int64_t id = 1; id <= robots; ++id) {
    telemetry_in_.emplace_back(participant_, RobotId{static_cast<std::uint16_t>(id)}, telemetry_);
  }
}

std::optional<RunStatus> RunListener::status() {
  const auto came = status_.collect();
  return came.empty() ? std::nullopt : std::optional(came.back());
}

std::string RunListener::doings() {
  for (const Telemetry& telemetry : telemetry_.collect()) {
    doing_[telemetry.robot] = doing(telemetry);
  }
  return doings_text(doing_);
}

}  // namespace tacit
