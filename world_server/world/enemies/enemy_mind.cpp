#include "world_server/world/enemies/enemy_mind.h"

namespace tacit {

EnemyMind::EnemyMind(const WorldConfig& config, const Terrain& terrain)
    : config_(config.enemies),
      terrain_(&terrain),
      target_m_(config.target.x_m, config.target.y_m),
      steering_(terrain, {config.enemies.avoid_reach_m, config.enemies.avoid_margin_m,
                          held_ticks(config.enemies.wander_hold_s, config.physics.tick_s)}),
      sight_(terrain, config.enemies.sight_range_m,
             {config.enemies.sight_blocked_by_obstacles, config.enemies.sight_blocked_by_walls}) {}

WorldVec EnemyMind::velocity(Enemy& enemy, const WorldVec& place_m, Tick tick) {
  steering_.refresh(enemy.wander, tick);
  return config_.speed_mps * steering_.direction(purpose(enemy, place_m), place_m);
}

WorldVec EnemyMind::purpose(const Enemy& enemy, const WorldVec& place_m) {
  if (enemy.kind == EnemyKind::Normal && sees_target(place_m)) {
    return unit(target_m_ - place_m) + config_.noise_gain * enemy.wander.heading;
  }
  const WorldVec back = enemy.appeared_m - place_m;
  const bool strayed = enemy.kind == EnemyKind::Decoy && back.norm() > config_.decoy_tether_m;
  return strayed ? unit(back) : enemy.wander.heading;
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

}  // namespace tacit
