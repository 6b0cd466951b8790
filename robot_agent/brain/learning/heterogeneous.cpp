#include "robot_agent/brain/learning/heterogeneous.h"

#include "idl/types/config_error.h"

namespace tacit {
namespace {

Role role_of(const Heterogeneous::Config& config, RobotId robot) {
  const std::int64_t length = config.foragers + config.soldiers + config.mechanics;
  if (length < 1) {
    throw ConfigError(
        "brain.heterogeneous: foragers, soldiers and mechanics are all 0, wanted at least one "
        "robot");
  }
  const std::int64_t place = (std::int64_t{robot.value} - 1 + length) % length;
  if (place < config.foragers) return Role::Forager;
  return place < config.foragers + config.soldiers ? Role::Soldier : Role::Mechanic;
}

}  // namespace

Heterogeneous::Heterogeneous(const Config& config, RobotId robot)
    : RoleSelector("heterogeneous"), role_(role_of(config, robot)) {}

Role Heterogeneous::choose(const RoleCue& /*cue*/) { return role_; }

void describe(Heterogeneous::Config& config, ParameterVisitor& visitor) {
  visitor.section("brain.heterogeneous",
                  "Roles for good: a pattern that is repeated over the robots' numbers.");
  constexpr Range kCounts{0.0, 1000.0};
  visitor.integer("foragers", config.foragers, kCounts,
                  {"robots", "Foragers at the start of the pattern [ours: half of the team]."});
  visitor.integer("soldiers", config.soldiers, kCounts,
                  {"robots", "Soldiers behind them [ours: a quarter of the team]."});
  visitor.integer("mechanics", config.mechanics, kCounts,
                  {"robots", "Mechanics behind those [ours: a quarter of the team]."});
}

}  // namespace tacit
