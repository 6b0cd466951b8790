#pragma once

#include <string_view>

#include "robot_agent/brain/schemas/schema.h"

namespace tacit {

/// Pulls straight to the centre line of the hallway that the robot is in, with strength
/// min(1, distance / width) (MissionLab's StayOnPath); nothing outside a hallway.
class StayOnPath final : public Schema {
 public:
  static constexpr std::string_view kName = "StayOnPath";

  [[nodiscard]] BodyVec push(const Surroundings& around) override;
};

}  // namespace tacit
