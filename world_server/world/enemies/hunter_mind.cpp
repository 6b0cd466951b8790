#include "world_server/world/enemies/hunter_mind.h"

#include <algorithm>

namespace tacit {
namespace {

// Against standstill behind obstacles. [ours: enough to get round a disc of 5 m dead ahead; a
// heading is held for some body lengths of way]
constexpr double kNoiseGain = 0.3;
constexpr double kWanderHold_s = 20.0;

double diagonal_m(const Terrain& terrain) {
  return WorldVec{terrain.width_m, terrain.height_m}.norm();
}

}  // namespace

HunterMind::HunterMind(const WorldConfig& config, const Terrain& terrain)
    : speed_mps_(config.forage.hunters.speed_mps),
      tick_s_(config.physics.tick_s),
      walls_(!terrain.walls.empty()),
      steering_(terrain, {config.forage.hunters.avoid_reach_m, config.forage.hunters.avoid_margin_m,
                          held_ticks(kWanderHold_s, config.physics.tick_s)}),
      way_(terrain, diagonal_m(terrain), {false, true}) {}

WorldVec HunterMind::velocity(Wander& wander, const WorldVec& place_m, const WorldVec& goal_m,
                              Tick tick) {
  steering_.refresh(wander, tick);
  const WorldVec to_goal_m = goal_m - place_m;
  const double speed_mps = std::min(speed_mps_, to_goal_m.norm() / tick_s_);
  return speed_mps * steering_.direction(purpose(wander, place_m, to_goal_m), place_m);
}

WorldVec HunterMind::purpose(const Wander& wander, const WorldVec& place_m,
                             const WorldVec& to_goal_m) {
  if (walls_) {
    way_.look_from(place_m);
    if (!way_.clear(to_goal_m)) {
      return wander.heading;
    }
  }
  return unit(to_goal_m) + kNoiseGain * wander.heading;
}

}  // namespace tacit
