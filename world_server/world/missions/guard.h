#pragma once

#include <vector>

#include "world_server/world/enemies/enemy_mind.h"
#include "world_server/world/enemies/spawner.h"
#include "world_server/world/missions/mission.h"

namespace tacit {

/// Keep enemies from a target (paper, section 2): they come in waves, a robot that reaches one
/// destroys it, and one that reaches the target destroys itself. It has no end.
class Guard final : public Mission {
 public:
  explicit Guard(Stage& stage);

  void set_out(Stage& stage) override;
  void settle(Stage& stage) override;

 private:
  void spawn(Stage& stage);
  /// Whether enemy k goes; says so.
  [[nodiscard]] bool ends(std::size_t k, Stage& stage) const;

  Spawner spawner_;
  EnemyMind mind_;
  std::uint32_t created_ = 0;
  std::vector<Enemy> enemies_;       ///< The stage's visitors, in the same order.
  std::vector<std::int64_t> alive_;  ///< Enemies alive, per wave.
  std::vector<std::uint8_t> gone_;
};

}  // namespace tacit
