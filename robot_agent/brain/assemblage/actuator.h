#pragma once

#include "idl/types/command.h"
#include "idl/types/parameters.h"

namespace tacit {

/// Turns the weighted sum into speed (MissionLab's actuator stage): the sum times the base speed,
/// clipped to the top speed. Robots are holonomic; they turn to face where they move.
class Actuator {
 public:
  struct Config {
    double base_mps = 2.0;
    double max_mps = 2.0;
    double max_turn_radps = 3.0;
    double turn_gain_per_s = 2.0;  ///< Turn rate per radian off the direction of motion.
    double turn_from_mps = 0.05;   ///< No turning at a wanted speed below this.
  };
  explicit Actuator(const Config& config) : config_(config) {}

  [[nodiscard]] BodyVec velocity_mps(const BodyVec& sum) const;
  [[nodiscard]] double turn_radps(const BodyVec& velocity_mps) const;
  /// To turn by `angle_rad` on the spot.
  [[nodiscard]] double turn_by_radps(double angle_rad) const;

 private:
  Config config_;
};

void describe(Actuator::Config& config, ParameterVisitor& visitor);

}  // namespace tacit
