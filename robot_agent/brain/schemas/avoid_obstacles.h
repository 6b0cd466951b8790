#pragma once

#include <string_view>

#include "idl/types/parameters.h"
#include "robot_agent/brain/schemas/schema.h"

namespace tacit {

/// Pushes straight away from the centre of every obstacle in reach (Arkin 1989,
/// avoid-static-obstacle).
///
/// One obstacle pushes with strength 0 at `reach_m` from its surface, 1 at `margin_m`, linearly
/// between, and with `kInfiniteRepulsion` nearer than that; the pushes of several add.
class AvoidObstacles final : public Schema {
 public:
  static constexpr std::string_view kName = "AvoidObstacles";
  static constexpr std::string_view kKey = "avoid_obstacles";

  struct Config {
    double reach_m = 3.0;
    double margin_m = 0.5;
  };
  /// Throws ConfigError unless margin_m < reach_m.
  explicit AvoidObstacles(const Config& config);
  [[nodiscard]] BodyVec push(const Surroundings& around) override;

 private:
  Config config_;
};

void describe(AvoidObstacles::Config& config, ParameterVisitor& visitor);

}  // namespace tacit
