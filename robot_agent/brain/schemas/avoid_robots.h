#pragma once

#include <string_view>

#include "robot_agent/brain/schemas/schema.h"

namespace tacit {

/// Pushes off from every robot in reach, half away from it and half past it on the right.
///
/// Strength as of AVOID_ROBOT (MissionLab): 0 at `reach_m` from its surface, 1 at `margin_m`,
/// linearly between, `kInfiniteRepulsion` nearer; the pushes of several add. The push past it is
/// MissionLab's Swirl, always by the right hand, so that two robots do not stand head to head
/// [ours: in a hallway neither can go round the other by repulsion alone].
class AvoidRobots final : public Schema {
 public:
  static constexpr std::string_view kName = "AvoidRobots";

  struct Config {
    double reach_m = 1.2;
    double margin_m = 0.3;
    bool friends = true;  ///< Whom it is about.
    bool enemies = true;
  };
  /// Throws ConfigError unless margin_m < reach_m.
  explicit AvoidRobots(const Config& config);
  [[nodiscard]] BodyVec push(const Surroundings& around) override;

 private:
  Config config_;
};

}  // namespace tacit
