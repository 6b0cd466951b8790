#pragma once

#include <string>
#include <vector>

#include "idl/types/event.h"
#include "idl/types/frames.h"
#include "idl/types/ids.h"
#include "idl/types/percept.h"

namespace tacit {

/// A moving body as a spectator sees it.
struct ViewedRobot {
  RobotId robot;
  WorldPose pose;
  WorldVec velocity_mps;
  bool present = true;  ///< False while its agent is lost.
};

struct ViewedEnemy {
  EnemyId enemy;
  EnemyKind kind = EnemyKind::Normal;
  WorldVec position_m;
};

/// The world from outside, for people and recordings; no robot reads it.
struct WorldView {
  static constexpr std::size_t kMaxBodies = 1024;  ///< Robots and enemies each.

  Tick tick = 0;
  double time_s = 0.0;  ///< Simulated.
  std::vector<ViewedRobot> robots;
  std::vector<ViewedEnemy> enemies;
};

}  // namespace tacit
