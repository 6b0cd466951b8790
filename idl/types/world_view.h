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
  bool present = true;   ///< False while its agent is lost.
  bool able = true;      ///< False while it is disabled.
  bool holding = false;  ///< It carries a mine or an object.
  Colour colour = Colour::Blue;
};

struct ViewedEnemy {
  EnemyId enemy;
  EnemyKind kind = EnemyKind::Normal;
  WorldVec position_m;
};

/// A mine that lies in the field; those that are carried or stored are not shown.
struct ViewedMine {
  MineId mine;
  WorldVec position_m;
};

/// An object of the map that lies in the field.
struct ViewedObject {
  ObjectId object;
  WorldVec position_m;
  double radius_m = 0.0;
  Colour colour = Colour::Brown;
};

/// The world from outside, for people and recordings; no robot reads it.
struct WorldView {
  static constexpr std::size_t kMaxBodies = 1024;  ///< Robots, enemies, mines and objects each.

  Tick tick = 0;
  double time_s = 0.0;  ///< Simulated.
  std::vector<ViewedRobot> robots;
  std::vector<ViewedEnemy> enemies;
  std::vector<ViewedMine> mines;
  std::vector<ViewedObject> objects;
};

}  // namespace tacit
