#pragma once

#include <string_view>

#include "idl/types/parameters.h"
#include "robot_agent/brain/schemas/schema.h"

namespace tacit {

/// Pushes straight away from every teammate in reach (MissionLab's AvoidRobot).
///
/// One teammate pushes with strength 0 at `reach_m`, 1 at `min_range_m`, linearly between, and
/// never more than `max_push`; the pushes of several add.
class AvoidSoldiers final : public Schema {
 public:
  static constexpr std::string_view kName = "AvoidSoldiers";
  static constexpr std::string_view kKey = "avoid_soldiers";

  struct Config {
    double reach_m = 75.0;
    double min_range_m = 2.0;
    double max_push = 1.0;  ///< Of one teammate.
  };
  /// Throws ConfigError unless min_range_m < reach_m.
  explicit AvoidSoldiers(const Config& config);
  [[nodiscard]] BodyVec push(const Surroundings& around) override;

 private:
  Config config_;
};

void describe(AvoidSoldiers::Config& config, ParameterVisitor& visitor);

}  // namespace tacit
