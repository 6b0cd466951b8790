#include "robot_agent/brain/roles/role_plans.h"

#include <algorithm>

#include "idl/types/config_error.h"
#include "robot_agent/brain/mission/compile.h"
#include "robot_agent/brain/roles/registry.h"

namespace tacit {
namespace {

constexpr const char* kName = "brain.roles.mission";

AutomatonPlan plan_of(const std::vector<RobotPlan>& robots, std::string_view role) {
  const auto robot = std::find_if(robots.begin(), robots.end(),
                                  [role](const RobotPlan& each) { return each.name == role; });
  if (robot == robots.end() || !robot->root.nested) {
    throw ConfigError(std::string(kName) + ": wanted a robot called " + std::string(role) +
                      " that an automaton drives");
  }
  AutomatonPlan plan = *robot->root.nested;
  plan.name = role;
  return plan;
}

}  // namespace

std::vector<AutomatonPlan> role_plans(const RolesConfig& config) {
  std::vector<AutomatonPlan> plans;
  if (config.mission.empty()) {
    for (const auto plan : kRolePlans) plans.push_back(plan(config));
    return plans;
  }
  const std::vector<RobotPlan> robots = compile_mission(config.mission, kName);
  for (const std::string_view role : kRoleNames) plans.push_back(plan_of(robots, role));
  return plans;
}

}  // namespace tacit
