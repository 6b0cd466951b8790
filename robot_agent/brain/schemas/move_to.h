#pragma once

#include <limits>
#include <string_view>

#include "robot_agent/brain/schemas/schema.h"

namespace tacit {

/// Pulls with strength 1 towards the nearest thing of some classes (MissionLab's MoveTo); nothing
/// while none is known. With a stand-off it stays so far from the thing's centre.
class MoveTo final : public Schema {
 public:
  static constexpr std::string_view kName = "MoveTo";

  struct Config {
    double max_range_m = std::numeric_limits<double>::infinity();
    double stand_off_m = 0.0;
  };
  MoveTo(ThingSet things, const Config& config) : things_(things), config_(config) {}
  explicit MoveTo(ThingSet things) : MoveTo(things, Config()) {}
  [[nodiscard]] BodyVec push(const Surroundings& around) override;

 private:
  ThingSet things_;
  Config config_;
};

}  // namespace tacit
