#pragma once

#include <cstdint>
#include <vector>

#include "deploy/lockstep/team.h"

namespace tacit {

/// A small area with enemies at every turn, so that much happens in few ticks.
inline WorldConfig busy_world(std::int64_t robots = 4) {
  WorldConfig config;
  config.area.width_m = 80.0;
  config.area.height_m = 80.0;
  config.target.x_m = 40.0;
  config.target.y_m = 40.0;
  config.obstacles.keep_free_m = 10.0;
  config.robots.count = robots;
  config.robots.ring_radius_m = 5.0;
  config.enemies.strategy = 4;
  config.enemies.period_scale = 0.5;
  return config;
}

inline BrainConfig brain_with(const char* learner) {
  BrainConfig config;
  config.learner = learner;
  return config;
}

/// All that a run leaves.
struct History {
  std::vector<Event> events;
  std::uint64_t digest = 0;
  friend bool operator==(const History&, const History&) = default;
};

inline void play(Team& team, Tick ticks, History& history) {
  for (Tick i = 0; i < ticks; ++i) {
    const auto events = team.step();
    history.events.insert(history.events.end(), events.begin(), events.end());
  }
  history.digest = team.world().digest();
}

}  // namespace tacit
