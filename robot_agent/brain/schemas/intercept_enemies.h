#pragma once

#include <optional>
#include <string_view>

#include "idl/types/parameters.h"
#include "robot_agent/brain/perception/quarry_track.h"
#include "robot_agent/brain/schemas/schema.h"

namespace tacit {

/// Pulls with strength 1 to where the quarry can be met.
///
/// The quarry is the nearest member of the nearest group that nobody occludes, or of the nearest
/// group when all are occluded. The robot leads it by the law of sines at its own recent speed,
/// and goes straight at it while there is no track or no meeting point.
class InterceptEnemies final : public Schema {
 public:
  static constexpr std::string_view kName = "InterceptEnemies";
  static constexpr std::string_view kKey = "intercept_enemies";

  struct Config {
    QuarryTrack::Config track;
  };
  explicit InterceptEnemies(const Config& config) : track_(config.track) {}
  [[nodiscard]] BodyVec push(const Surroundings& around) override;

 private:
  QuarryTrack track_;
};

/// The direction in which a robot of speed `speed` meets a quarry that is seen in the direction
/// `towards` (unit length) and moves with `quarry_velocity`, both in the same unit of speed. Empty
/// when it cannot be met.
[[nodiscard]] std::optional<BodyVec> lead(const BodyVec& towards, const BodyVec& quarry_velocity,
                                          double speed);

void describe(InterceptEnemies::Config& config, ParameterVisitor& visitor);

}  // namespace tacit
