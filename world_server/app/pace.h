#pragma once

#include <cstdint>
#include <optional>

#include "idl/bus/bell.h"
#include "idl/types/roster.h"

namespace tacit {

/// When the next tick may begin: as fast as it goes, at a multiple of real time, or when a person
/// says so.
class Pace {
 public:
  using Time = Bell::Clock::time_point;

  /// `speed` times real time, 0 for as fast as it goes; a tick is `tick_s` > 0 of simulated time.
  Pace(double speed, double tick_s) : speed_(speed), tick_s_(tick_s) {}

  /// An operator's word to a robot is not for the pace.
  void hear(const Control& control);
  /// None while paused with no step left; not after `now` when it is time.
  [[nodiscard]] std::optional<Time> next_tick_at(Time now) const;
  /// A tick began at `now`. A server that has fallen behind does not hurry to make up for it.
  void began(Time now);

  [[nodiscard]] bool paused() const { return paused_; }
  [[nodiscard]] double speed() const { return speed_; }
  [[nodiscard]] bool stopped() const { return stopped_; }

 private:
  [[nodiscard]] Bell::Clock::duration period() const;

  double speed_;
  double tick_s_;
  bool paused_ = false;
  bool stopped_ = false;
  std::uint64_t steps_left_ = 0;
  std::optional<Time> due_;
};

}  // namespace tacit
