#pragma once

#include <string_view>

#include "robot_agent/brain/schemas/schema.h"

namespace tacit {

/// Pushes away from the nearest thing of some classes (MissionLab's MoveAway): strength 0 at
/// `reach_m` from its surface, 1 at `margin_m`, linearly between, `kInfiniteRepulsion` nearer than
/// that.
class MoveAwayFrom final : public Schema {
 public:
  static constexpr std::string_view kName = "MoveAwayFrom";

  struct Config {
    double reach_m = 1.2;
    double margin_m = 0.3;
  };
  /// Throws ConfigError unless margin_m < reach_m.
  MoveAwayFrom(ThingSet things, const Config& config);
  [[nodiscard]] BodyVec push(const Surroundings& around) override;

 private:
  ThingSet things_;
  Config config_;
};

}  // namespace tacit
