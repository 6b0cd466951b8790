#pragma once

#include <cstdint>

#include "idl/types/event.h"
#include "world_server/world/enemies/steering.h"
#include "world_server/world/sensing/line_of_sight.h"
#include "world_server/world/terrain.h"
#include "world_server/world/world_config.h"

namespace tacit {

/// What an enemy keeps from tick to tick.
struct Enemy {
  EnemyId id;
  EnemyKind kind = EnemyKind::Normal;
  std::size_t wave = 0;
  WorldVec appeared_m;  ///< Where it appeared.
  Wander wander;
};

/// How enemies move. Normal enemies go straight to the target while it is in sight and wander
/// otherwise; decoys wander near where they appeared (paper, section 2). Both avoid obstacles, by
/// the same repulsion as the robots.
class EnemyMind {
 public:
  /// Keeps a reference to `terrain`.
  EnemyMind(const WorldConfig& config, const Terrain& terrain);

  /// The velocity that `enemy`, now at `place_m`, wants at `tick`.
  [[nodiscard]] WorldVec velocity(Enemy& enemy, const WorldVec& place_m, Tick tick);

 private:
  [[nodiscard]] bool sees_target(const WorldVec& place_m);
  [[nodiscard]] WorldVec purpose(const Enemy& enemy, const WorldVec& place_m);

  EnemyConfig config_;
  const Terrain* terrain_;
  WorldVec target_m_;
  Steering steering_;
  LineOfSight sight_;
};

}  // namespace tacit
