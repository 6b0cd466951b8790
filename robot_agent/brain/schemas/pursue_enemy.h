#pragma once

#include <string_view>

#include "robot_agent/brain/schemas/schema.h"

namespace tacit {

/// Pulls with strength 1 to where the nearest enemy can be met, at the robot's own recent speed
/// (MissionLab's Intercept); straight at it while there is no track or no meeting point.
class PursueEnemy final : public Schema {
 public:
  static constexpr std::string_view kName = "PursueEnemy";

  [[nodiscard]] BodyVec push(const Surroundings& around) override;
};

}  // namespace tacit
