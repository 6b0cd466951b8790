#pragma once

#include <string_view>

#include "robot_agent/brain/schemas/schema.h"

namespace tacit {

/// Pulls with strength 1 towards the nearest thing of a class (MissionLab's MoveToward); nothing
/// while none is known.
class MoveTo final : public Schema {
 public:
  static constexpr std::string_view kName = "MoveTo";

  explicit MoveTo(Thing thing) : thing_(thing) {}
  [[nodiscard]] BodyVec push(const Surroundings& around) override;

 private:
  Thing thing_;
};

}  // namespace tacit
