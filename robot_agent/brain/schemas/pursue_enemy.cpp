#include "robot_agent/brain/schemas/pursue_enemy.h"

#include "robot_agent/brain/schemas/intercept_enemies.h"

namespace tacit {

BodyVec PursueEnemy::push(const Surroundings& around) {
  const Nearest& quarry = around.nearest_of(Thing::Enemy);
  if (!quarry.known() || quarry.squared_range_m2 == 0.0) return {};
  const BodyVec straight = (1.0 / std::sqrt(quarry.squared_range_m2)) * quarry.offset_m;
  if (!around.quarry) return straight;
  const BodyVec quarry_m_per_tick =
      to_body(around.odometry.heading, around.quarry->quarry_m_per_tick);
  return lead(straight, quarry_m_per_tick, around.quarry->self_m_per_tick.norm())
      .value_or(straight);
}

}  // namespace tacit
