#pragma once

#include <cstdint>
#include <string_view>

#include "idl/types/parameters.h"
#include "idl/types/random.h"
#include "robot_agent/brain/schemas/schema.h"

namespace tacit {

/// Pulls with strength 1 in a random direction, which stays the same in the odometry frame for
/// `persistence_ticks` (MissionLab's Noise; with avoidance it makes a robot wander).
///
/// The direction is a function of seed, robot and tick alone, so a restarted brain wanders on as
/// if nothing had happened.
class Noise final : public Schema {
 public:
  static constexpr std::string_view kName = "Noise";
  static constexpr std::string_view kKey = "noise";

  struct Config {
    std::int64_t persistence_ticks = 10;  ///< >= 1
  };
  Noise(const Config& config, const Self& self);
  [[nodiscard]] BodyVec push(const Surroundings& around) override;

 private:
  [[nodiscard]] OdometryVec drawn(std::uint64_t period);

  Tick persistence_ticks_;
  Stream stream_;
  std::uint64_t period_ = 0;  ///< Of `direction_`.
  OdometryVec direction_;
};

void describe(Noise::Config& config, ParameterVisitor& visitor);

}  // namespace tacit
