#pragma once

#include <string_view>

#include "robot_agent/brain/schemas/schema.h"

namespace tacit {

/// Pulls to open ground (MissionLab's MoveToFreeSpace): of twelve sectors of 30 degrees, towards
/// the middle of the clear one nearest to the heading, the left one of two, with strength 1 - k/6
/// for the k-th sector off the heading; nothing when none is clear.
class MoveToFreeSpace final : public Schema {
 public:
  static constexpr std::string_view kName = "MoveToFreeSpace";

  struct Config {
    double horizon_m = 2.0;  ///< A surface nearer than this bars its sector.
  };
  explicit MoveToFreeSpace(const Config& config) : config_(config) {}
  [[nodiscard]] BodyVec push(const Surroundings& around) override;

 private:
  Config config_;
};

}  // namespace tacit
