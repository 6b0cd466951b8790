#pragma once

#include "robot_agent/brain/learning/role_selector.h"

namespace tacit {

/// The paper's homogeneous team: "the default role was FORAGER. However, a robot switches to
/// SOLDIER in the presence of an enemy, and switches to MECHANIC whenever a dead robot was
/// detected." When both are seen, the enemy comes first: ours, as it would only make more work for
/// mechanics.
class Homogeneous final : public RoleSelector {
 public:
  Homogeneous() : RoleSelector("homogeneous") {}
  [[nodiscard]] Role choose(const RoleCue& cue) override;
};

}  // namespace tacit
