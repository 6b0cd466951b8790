#include "robot_agent/brain/learning/homogeneous.h"

namespace tacit {

Role Homogeneous::choose(const RoleCue& cue) {
  if (cue.around.nearest_of(Thing::Enemy).known()) return Role::Soldier;
  if (cue.around.nearest_of(Thing::Disabled).known()) return Role::Mechanic;
  return Role::Forager;
}

}  // namespace tacit
