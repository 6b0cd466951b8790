#include "world_server/world/enemies/enemy_mind.h"

#include <algorithm>
#include <cmath>

#include "idl/types/repulsion.h"

namespace tacit {
namespace {

// Below this the pushes cancel out and have no direction worth following.
constexpr double kStill = 0.05;

}  // namespace

EnemyMind::EnemyMind(const WorldConfig& config, const Terrain& terrain)
    : config_(config.enemies),
      terrain_(&terrain),
      target_m_(config.target.x_m, config.target.y_m),
      wander_ticks_(static_cast<Tick>(
          std::max(1.0, std::floor(config.enemies.wander_hold_s / config.physics.tick_s + 0.5)))),
      near_(terrain, config.enemies.avoid_reach_m),
      sight_(terrain, config.enemies.sight_range_m,
             {config.enemies.sight_blocked_by_obstacles, config.enemies.sight_blocked_by_walls}) {}

WorldVec EnemyMind::velocity(Enemy& enemy, const WorldVec& place_m, Tick tick) {
  refresh_wander(enemy, tick);
  const WorldVec wanted = purpose(enemy, place_m) + away_from_obstacles(place_m);
  // An enemy never dawdles: it moves at full speed wherever the sum points.
  return wanted.norm() > kStill ? config_.speed_mps * unit(wanted) : WorldVec{};
}

WorldVec EnemyMind::purpose(const Enemy& enemy, const WorldVec& place_m) {
  if (enemy.kind == EnemyKind::Normal && sees_target(place_m)) {
    return unit(target_m_ - place_m) + config_.noise_gain * enemy.wander;
  }
  const WorldVec back = enemy.appeared_m - place_m;
  const bool strayed = enemy.kind == EnemyKind::Decoy && back.norm() > config_.decoy_tether_m;
  return strayed ? unit(back) : enemy.wander;
}

bool EnemyMind::sees_target(const WorldVec& place_m) {
  const WorldVec offset = target_m_ - place_m;
  if (offset.squared_norm() > config_.sight_range_m * config_.sight_range_m) {
    return false;
  }
  if (!config_.sight_blocked_by_obstacles &&
      (!config_.sight_blocked_by_walls || terrain_->walls.empty())) {
    return true;
  }
  sight_.look_from(place_m);
  return sight_.clear(offset);
}

WorldVec EnemyMind::away_from_obstacles(const WorldVec& place_m) const {
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

void EnemyMind::refresh_wander(Enemy& enemy, Tick tick) const {
  if (tick >= enemy.wander_until) {
    const Heading heading = Heading::from_rad(enemy.chance.uniform(-kPi, kPi));
    enemy.wander = {heading.cos, heading.sin};
    enemy.wander_until = tick + wander_ticks_;
  }
}

}  // namespace tacit
