#pragma once

#include <cstdint>

#include "robot_agent/brain/perception/enemy_groups.h"
#include "robot_agent/brain/perception/occlusion.h"
#include "robot_agent/brain/perception/place_memory.h"
#include "robot_agent/brain/perception/surroundings.h"

namespace tacit {

/// What a brain has a use for.
enum class Attention : std::uint8_t {
  Everything,
  NoEnemies,  ///< Enemies are left out and no groups are sought.
};

/// Turns percepts into surroundings. Allocates nothing once it has seen the largest percept.
class Perception {
 public:
  Perception(const EnemyGroups& groups, const Occlusion& occlusion, Attention attention);

  /// Call once per tick, ticks ascending. The result borrows from `percept` and from this.
  [[nodiscard]] const Surroundings& look(const Percept& percept);

 private:
  void sort(const Percept& percept);
  [[nodiscard]] const EnemyGroup* nearest_open_group() const;

  EnemyGroups groups_;
  Occlusion occlusion_;
  Attention attention_;
  PlaceMemory target_;
  Surroundings around_;
};

}  // namespace tacit
