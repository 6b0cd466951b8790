#include "console/app/run_listener.h"

#include "console/report/progress_text.h"

namespace tacit {

RunListener::RunListener(const Identity& identity, std::int64_t robots, Views views, Bell& bell)
    : events_(bell),
      views_(bell),
      status_(bell),
      telemetry_(bell),
      participant_(identity),
      events_in_(participant_, RobotId{}, events_),
      status_in_(participant_, RobotId{}, status_) {
  if (views == Views::EveryTick) trajectory_in_.emplace(participant_, RobotId{}, views_);
  if (views == Views::SomeTimesASecond) view_in_.emplace(participant_, RobotId{}, views_);
  for (std::int64_t id = 1; id <= robots; ++id) {
    telemetry_in_.emplace_back(participant_, RobotId{static_cast<std::uint16_t>(id)}, telemetry_);
  }
}

void RunListener::telemetry(const Take<Telemetry>& take) {
  hear<Telemetry>(telemetry_, telemetry_word_, [&](const Telemetry& telemetry, Bytes bytes) {
    doing_[telemetry.robot] = doing(telemetry);
    take(telemetry, bytes);
  });
}

std::string RunListener::doings() const { return doings_text(doing_); }

}  // namespace tacit
