#include "world_server/app/pace.h"

#include <algorithm>

namespace tacit {
namespace {

/// Lateness up to this is made up for, so that the pace holds on average.
constexpr std::chrono::milliseconds kSlack{100};

}  // namespace

void Pace::hear(const Control& control) {
  switch (control.kind) {
    case ControlKind::Pause:
      paused_ = true;
      steps_left_ = 0;
      return;
    case ControlKind::Resume:
      paused_ = false;
      due_.reset();
      return;
    case ControlKind::Step:
      if (paused_) steps_left_ += control.ticks;
      return;
    case ControlKind::Speed:
      speed_ = control.speed;
      due_.reset();
      return;
    case ControlKind::Stop:
      stopped_ = true;
      return;
    case ControlKind::Steer:
    case ControlKind::LetGo:
    case ControlKind::Proceed:
    case ControlKind::SkipGoal:
      return;
  }
}

std::optional<Pace::Time> Pace::next_tick_at(Time now) const {
  if (paused_) return steps_left_ > 0 ? std::optional(now) : std::nullopt;
  return speed_ > 0.0 && due_ ? *due_ : now;
}

void Pace::began(Time now) {
  if (paused_) {
    --steps_left_;
  } else if (speed_ > 0.0) {
    due_ = std::max(due_.value_or(now), now - kSlack) + period();
  }
}

Bell::Clock::duration Pace::period() const {
  return std::chrono::duration_cast<Bell::Clock::duration>(
      std::chrono::duration<double>(tick_s_ / speed_));
}

}  // namespace tacit
