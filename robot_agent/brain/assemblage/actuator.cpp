#include "robot_agent/brain/assemblage/actuator.h"

#include <algorithm>

namespace tacit {

BodyVec Actuator::velocity_mps(const BodyVec& sum) const {
  return clipped(config_.base_mps * sum, config_.max_mps);
}

double Actuator::turn_radps(const BodyVec& velocity_mps) const {
  const double least_mps = config_.turn_from_mps;
  if (velocity_mps.squared_norm() < least_mps * least_mps) return 0.0;
  return turn_by_radps(arc_tangent(velocity_mps.y(), velocity_mps.x()));
}

double Actuator::turn_by_radps(double angle_rad) const {
  return std::clamp(config_.turn_gain_per_s * angle_rad, -config_.max_turn_radps,
                    config_.max_turn_radps);
}

void describe(Actuator::Config& config, ParameterVisitor& visitor) {
  visitor.section("brain.actuator", "How the weighted sum becomes a command.");
  visitor.number("base_mps", config.base_mps, {0.0, 100.0},
                 {"m/s", "Speed wanted for a sum of length 1 [ours: equal to the top speed]."});
  visitor.number("max_mps", config.max_mps, {0.0, 100.0},
                 {"m/s",
                  "Top speed [ours: a little above the enemies', or interception is either trivial "
                  "or hopeless]."});
  visitor.number("max_turn_radps", config.max_turn_radps, {0.0, 100.0},
                 {"rad/s", "Fastest turn wanted [ours: half a turn in a second]."});
  visitor.number("turn_gain_per_s", config.turn_gain_per_s, {0.0, 100.0},
                 {"1/s",
                  "Turn rate per radian between heading and motion [ours: settles within two "
                  "seconds without overshoot]."});
  visitor.number("turn_from_mps", config.turn_from_mps, {0.0, 100.0},
                 {"m/s",
                  "Wanted speed below which the robot does not turn [ours: a robot at rest keeps "
                  "its heading]."});
}

}  // namespace tacit
