#pragma once

#include <optional>

#include "idl/bus/bell.h"
#include "idl/bus/publisher.h"
#include "world_server/world/world.h"

namespace tacit {

/// Shows the world to those who watch: a few times a second, and at every tick if trajectories are
/// recorded. Costs next to nothing while nobody watches.
class Gallery {
 public:
  using Time = Bell::Clock::time_point;
  enum class Trajectories { Off, On };

  Gallery(Participant& participant, double view_hz, Trajectories trajectories);

  void show(const World& world, const std::vector<bool>& present, Time now);
  /// Whether all that is recorded has a reader.
  [[nodiscard]] bool has_recorder() const { return !trajectory_ || trajectory_->readers() > 0; }
  [[nodiscard]] bool wait_received(std::chrono::milliseconds patience);

 private:
  Publisher<topics::WorldView> view_;
  std::optional<Publisher<topics::Trajectory>> trajectory_;
  Bell::Clock::duration period_;
  Time next_view_{};
  WorldView scratch_;
};

}  // namespace tacit
