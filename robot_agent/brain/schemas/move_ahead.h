#pragma once

#include <optional>
#include <string_view>

#include "robot_agent/brain/schemas/schema.h"

namespace tacit {

/// Pulls with strength 1 the way the robot faced when its state was entered, turned by an angle
/// (MissionLab's MoveAhead).
class MoveAhead final : public Schema {
 public:
  static constexpr std::string_view kName = "MoveAhead";

  struct Config {
    double turned_deg = 0.0;  ///< Counter-clockwise.
  };
  explicit MoveAhead(const Config& config) : config_(config) {}
  void enter() override { way_.reset(); }
  [[nodiscard]] BodyVec push(const Surroundings& around) override;

 private:
  Config config_;
  std::optional<OdometryVec> way_;
};

}  // namespace tacit
