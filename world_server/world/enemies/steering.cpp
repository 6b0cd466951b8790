#include "world_server/world/enemies/steering.h"

#include <algorithm>
#include <cmath>

#include "idl/types/repulsion.h"

namespace tacit {
namespace {

// Below this the pushes cancel out and have no direction worth following.
constexpr double kStill = 0.05;

}  // namespace

Steering::Steering(const Terrain& terrain, const Config& config)
    : config_(config), terrain_(&terrain), near_(terrain, config.avoid_reach_m) {}

void Steering::refresh(Wander& wander, Tick tick) const {
  if (tick >= wander.until) {
    const Heading heading = Heading::from_rad(wander.chance.uniform(-kPi, kPi));
    wander.heading = {heading.cos, heading.sin};
    wander.until = tick + config_.wander_ticks;
  }
}

WorldVec Steering::direction(const WorldVec& purpose, const WorldVec& place_m) const {
  const WorldVec wanted = purpose + away_from_obstacles(place_m);
  return wanted.norm() > kStill ? unit(wanted) : WorldVec{};
}

WorldVec Steering::away_from_obstacles(const WorldVec& place_m) const {
  const auto push = [this, &place_m](const WorldVec& surface_centre, double radius_m) {
    const WorldVec away = place_m - surface_centre;
    const double range_m = away.norm();
    return repulsion(range_m - radius_m, config_.avoid_reach_m, config_.avoid_margin_m) *
           unit(away);
  };
  WorldVec total;
  const NearMap::Near near = near_.near(place_m);
  for (const std::uint16_t i : near.obstacles) {
    total += push(terrain_->obstacles[i].centre_m, terrain_->obstacles[i].radius_m);
  }
  for (const std::uint16_t i : near.walls) {
    total += push(nearest_point(terrain_->walls[i], place_m), 0.0);
  }
  return total;
}

Tick held_ticks(double hold_s, double tick_s) {
  return static_cast<Tick>(std::max(1.0, std::floor(hold_s / tick_s + 0.5)));
}

}  // namespace tacit
