#include "robot_agent/brain/roles/soldier.h"

#include "robot_agent/brain/roles/activities.h"

namespace tacit {

AutomatonPlan soldier(const RolesConfig& config) {
  // clang-format off
  return {"Soldier", {
      // state        activity          if                            goto
      {"Patrol",      wander(config),  {{Detect{Thing::Enemy},        "Intercept"}}},
      {"Intercept",   pursue(config),  {{NotDetected{Thing::Enemy},   "Patrol"}}},
  }};
  // clang-format on
}

}  // namespace tacit
