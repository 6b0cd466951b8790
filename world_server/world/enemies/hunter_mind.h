#pragma once

#include "world_server/world/enemies/steering.h"
#include "world_server/world/sensing/line_of_sight.h"
#include "world_server/world/world_config.h"

namespace tacit {

/// How a hunter moves: straight to its goal, round obstacles as all enemies, and by chance while an
/// inner wall lies in between. It knows where its goal is, seen or not [ours: the paper's enemy
/// "will find the nearest robot"].
class HunterMind {
 public:
  /// Keeps a reference to `terrain`.
  HunterMind(const WorldConfig& config, const Terrain& terrain);

  /// The velocity of a hunter at `place_m` that wants to get to `goal_m`. It does not run beyond
  /// its goal.
  [[nodiscard]] WorldVec velocity(Wander& wander, const WorldVec& place_m, const WorldVec& goal_m,
                                  Tick tick);

 private:
  [[nodiscard]] WorldVec purpose(const Wander& wander, const WorldVec& place_m,
                                 const WorldVec& to_goal_m);

  double speed_mps_;
  double tick_s_;
  bool walls_;
  Steering steering_;
  LineOfSight way_;
};

}  // namespace tacit
