#pragma once

#include <string_view>

#include "robot_agent/brain/schemas/schema.h"

namespace tacit {

/// Pulls as the operator holds the joystick, with strength 0 to 1 (MissionLab's Telop, which stands
/// in every moving behaviour).
class Telop final : public Schema {
 public:
  static constexpr std::string_view kName = "Telop";

  [[nodiscard]] BodyVec push(const Surroundings& around) override {
    const OperatorInput& operated = around.premises.operated;
    return operated.teleoperated ? operated.joystick : BodyVec{};
  }
};

}  // namespace tacit
