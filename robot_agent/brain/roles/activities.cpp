#include "robot_agent/brain/roles/activities.h"

#include "robot_agent/brain/schemas/avoid_obstacles.h"
#include "robot_agent/brain/schemas/avoid_soldiers.h"
#include "robot_agent/brain/schemas/move_to.h"
#include "robot_agent/brain/schemas/noise.h"
#include "robot_agent/brain/schemas/pursue_enemy.h"

namespace tacit {
namespace {

SchemaUse use(std::string_view schema, double gain, ThingSet things = {}) {
  return {std::string(schema), gain, things, {}};
}

ActivityPlan moving(std::vector<SchemaUse> schemas, const RolesConfig& config, Act act) {
  schemas.push_back(use(AvoidObstacles::kName, config.avoid_obstacles_gain));
  schemas.push_back(use(AvoidSoldiers::kName, config.avoid_teammates_gain));
  return {std::move(schemas), {.act = act}, Turn::None, {}};
}

}  // namespace

ActivityPlan wander(const RolesConfig& config) {
  return moving({use(Noise::kName, config.wander_gain)}, config, Act::None);
}

ActivityPlan approach(Thing thing, const RolesConfig& config, Act act) {
  return moving({use(MoveTo::kName, config.approach_gain, thing),
                 use(Noise::kName, config.approach_noise_gain)},
                config, act);
}

ActivityPlan pursue(const RolesConfig& config) {
  return moving({use(PursueEnemy::kName, config.pursuit_gain)}, config, Act::Intercept);
}

ActivityPlan stand(Act act) { return {{}, {.act = act}, Turn::None, {}}; }

}  // namespace tacit
