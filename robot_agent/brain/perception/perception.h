#pragma once

#include <cstdint>

#include "robot_agent/brain/perception/enemy_groups.h"
#include "robot_agent/brain/perception/surroundings.h"
#include "robot_agent/brain/perception/target_memory.h"

namespace tacit {

/// What a brain has a use for.
enum class Attention : std::uint8_t {
  Everything,
  NoEnemies,  ///< Enemies are left out and no groups are sought.
};

/// Turns percepts into surroundings. Allocates nothing once it has seen the largest percept.
class Perception {
 public:
  Perception(const EnemyGroups::Config& config, Attention attention);

  /// Call once per tick, ticks ascending. The result borrows from `percept` and from this.
  [[nodiscard]] const Surroundings& look(const Percept& percept);

 private:
  void sort(const Percept& percept);

  EnemyGroups groups_;
  Attention attention_;
  TargetMemory target_;
  Surroundings around_;
};

}  // namespace tacit
