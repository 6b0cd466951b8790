#include "robot_agent/brain/roles/mechanic.h"

#include "robot_agent/brain/roles/activities.h"

namespace tacit {

AutomatonPlan mechanic(const RolesConfig& config) {
  const double near_m = config.near_disabled_m;
  const ActivityPlan to_disabled = approach(Thing::Disabled, config);
  const ActivityPlan aid = approach(Thing::Disabled, config, Act::Aid);
  // clang-format off
  return {"Mechanic", {
      // state             activity         if                                  goto
      {"Search",           wander(config), {{Detect{Thing::Disabled},           "MoveToDisabled"}}},
      {"MoveToDisabled",   to_disabled,    {{NotDetected{Thing::Disabled},      "Search"},
                                            {Near{Thing::Disabled, near_m},     "Aid"}}},
      {"Aid",              aid,            {{NotDetected{Thing::Disabled},      "Search"},
                                            {AwayFrom{Thing::Disabled, near_m}, "MoveToDisabled"}}},
  }};
  // clang-format on
}

}  // namespace tacit
