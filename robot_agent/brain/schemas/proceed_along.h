#pragma once

#include <optional>
#include <string_view>

#include "robot_agent/brain/schemas/schema.h"

namespace tacit {

/// Which way along a hallway, seen from a robot in it.
enum class HallwayWay : std::uint8_t {
  Facing,  ///< As it faces; across the hallway as it went along it last, unless it ends there.
  Left,    ///< To its left; where it faces along the hallway, as it faces.
  Right,
};

/// Pulls with strength 1 along the hallway that the robot is in, up to its end (MissionLab's
/// ProceedAlongHallway, move-to part); nothing outside a hallway.
///
/// The way is chosen once in a state, in its first push in a hallway.
class ProceedAlong final : public Schema {
 public:
  static constexpr std::string_view kName = "ProceedAlong";

  struct Config {
    HallwayWay way = HallwayWay::Facing;
  };
  ProceedAlong(const Config& config, const Self& self)
      : way_(config.way), errand_(self.errand ? self.errand : std::make_shared<Errand>()) {}
  void enter() override { chosen_.reset(); }
  [[nodiscard]] BodyVec push(const Surroundings& around) override;

 private:
  [[nodiscard]] BodyVec choose(const SeenHallway& hallway, const Surroundings& around) const;

  HallwayWay way_;
  std::shared_ptr<Errand> errand_;
  std::optional<OdometryVec> chosen_;
};

}  // namespace tacit
