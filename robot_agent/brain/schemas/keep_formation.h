#pragma once

#include <string_view>

#include "robot_agent/brain/schemas/schema.h"

namespace tacit {

/// Pulls to the robot's place in a formation that heads for a goal (Balch and Arkin 1998,
/// unit-centre-referenced): the centre is the mean place of the robot and the teammates in sight.
///
/// Within `dead_zone_m` of the place nothing, then growing linearly to 1 over `saturation_m`, 1
/// beyond (MissionLab's MaintainFormation).
class KeepFormation final : public Schema {
 public:
  static constexpr std::string_view kName = "KeepFormation";

  struct Config {
    WorldVec goal_m;
    double ahead_m = 0.0;  ///< The place, from the formation's centre, towards the goal …
    double left_m = 0.0;   ///< … and to the left of that.
    double dead_zone_m = 0.5;
    double saturation_m = 5.0;
  };
  explicit KeepFormation(const Config& config) : config_(config) {}
  [[nodiscard]] BodyVec push(const Surroundings& around) override;

 private:
  Config config_;
};

/// The mean place of the robot and the teammates in sight, body frame.
[[nodiscard]] BodyVec unit_centre_m(const Premises& here);

}  // namespace tacit
