#include "console/app/run_listener.h"

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

std::string RunListener::situations() {
  for (const Telemetry& telemetry : telemetry_.collect()) {
    situation_of_[telemetry.robot] = telemetry.situation;
  }
  std::map<std::string, int> robots_in;
  for (const auto& [robot, situation] : situation_of_) {
    if (!situation.empty()) {
      ++robots_in[situation];
    }
  }
  std::string text;
  for (const auto& [situation, robots] : robots_in) {
    text += (text.empty() ? "" : ", ") + std::to_string(robots) + ' ' + situation;
  }
  return text;
}

}  // namespace tacit
