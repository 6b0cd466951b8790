#include "robot_agent/brain/schemas/noise.h"

namespace tacit {

Noise::Noise(const Config& config, const Self& self)
    : persistence_ticks_(static_cast<Tick>(config.persistence_ticks)),
      stream_(self.seed, "noise", self.robot.value),
      direction_(drawn(period_)) {}

BodyVec Noise::push(const Surroundings& around) {
  const std::uint64_t period = around.tick / persistence_ticks_;
  if (period != period_) {
    period_ = period;
    direction_ = drawn(period);
  }
  return to_body(around.odometry.heading, direction_);
}

OdometryVec Noise::drawn(std::uint64_t period) {
  stream_.seek(period);
  const SinCos sc = sin_cos(stream_.uniform(-kPi, kPi));
  return {sc.cos, sc.sin};
}

void describe(Noise::Config& config, ParameterVisitor& visitor) {
  visitor.section("brain.noise", "Noise: a unit pull in a random direction.");
  visitor.integer("persistence_ticks", config.persistence_ticks, {1, 1e9},
                  {"ticks", "How long a direction is held [MissionLab]."});
}

}  // namespace tacit
