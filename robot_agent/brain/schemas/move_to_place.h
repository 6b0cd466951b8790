#pragma once

#include <string_view>

#include "robot_agent/brain/schemas/schema.h"

namespace tacit {

/// Pulls with strength 1 towards a place on the map (MissionLab's MoveTo, also GoTo's); nothing on
/// the spot.
class MoveToPlace final : public Schema {
 public:
  static constexpr std::string_view kName = "MoveToPlace";

  struct Config {
    WorldVec goal_m;
  };
  explicit MoveToPlace(const Config& config) : goal_m_(config.goal_m) {}
  [[nodiscard]] BodyVec push(const Surroundings& around) override;

 private:
  WorldVec goal_m_;
};

}  // namespace tacit
