#include "robot_agent/brain/schemas/avoid_soldiers.h"

#include <algorithm>

#include "idl/types/config_error.h"
#include "idl/types/repulsion.h"
#include "idl/types/shortest.h"

namespace tacit {

AvoidSoldiers::AvoidSoldiers(const Config& config) : config_(config) {
  if (!(config.min_range_m < config.reach_m)) {
    throw ConfigError("brain.avoid_soldiers: min_range_m is " + shortest(config.min_range_m) +
                      ", wanted less than reach_m, which is " + shortest(config.reach_m));
  }
}

BodyVec AvoidSoldiers::push(const Surroundings& around) {
  BodyVec total;
  for (const Seen& mate : around.teammates) {
    if (mate.range_m >= config_.reach_m || mate.range_m == 0.0) continue;
    const double strength =
        std::min(repulsion(mate.range_m, config_.reach_m, config_.min_range_m), config_.max_push);
    total -= (strength / mate.range_m) * mate.offset_m;
  }
  return total;
}

void describe(AvoidSoldiers::Config& config, ParameterVisitor& visitor) {
  visitor.section("brain.avoid_soldiers", "AvoidSoldiers: a push away from each teammate.");
  visitor.number("reach_m", config.reach_m, {0.001, 1e6},
                 {"m",
                  "Range at which a teammate starts to push [ours: the soldiers' sensing range, so "
                  "that a team spreads as far as it sees]."});
  visitor.number("min_range_m", config.min_range_m, {0.0, 1e6},
                 {"m", "Range at which the linear push reaches 1 [ours: ten body radii]."});
  visitor.number("max_push", config.max_push, {0.0, 20.0},
                 {"",
                  "The strongest push of one teammate [ours: MissionLab's infinity would outweigh "
                  "an enemy within reach]."});
}

}  // namespace tacit
