#include "world_server/app/gallery.h"

namespace tacit {

Gallery::Gallery(Participant& participant, double view_hz, Trajectories trajectories)
    : view_(participant),
      period_(std::chrono::duration_cast<Bell::Clock::duration>(
          std::chrono::duration<double>(1.0 / view_hz))) {
  if (trajectories == Trajectories::On) trajectory_.emplace(participant);
}

void Gallery::show(const World& world, const std::vector<bool>& present, Time now) {
  const bool view_due = now >= next_view_ && view_.readers() > 0;
  if (!view_due && !trajectory_) return;
  world.view(scratch_);
  for (ViewedRobot& robot : scratch_.robots) {
    robot.present = present[static_cast<std::size_t>(robot.robot.value) - 1];
  }
  if (trajectory_) trajectory_->publish(scratch_);
  if (view_due) {
    view_.publish(scratch_);
    next_view_ = now + period_;
  }
}

bool Gallery::wait_received(std::chrono::milliseconds patience) {
  return !trajectory_ || trajectory_->wait_received(patience);
}

}  // namespace tacit
