#pragma once

#include <optional>
#include <string_view>

#include "robot_agent/brain/schemas/schema.h"

namespace tacit {

/// Pulls with strength 1 through a doorway (MissionLab's EnterRoom and LeaveRoom): to a point
/// before it, when it comes at a slant, then through its middle to `beyond_m` on the other side.
///
/// The doorway is chosen once in a state, in the first push in which one can be seen: the nearest,
/// for a robot that leaves the one through which it came in, also out of sight. Nothing until then.
class PassDoorway final : public Schema {
 public:
  static constexpr std::string_view kName = "PassDoorway";

  struct Config {
    bool leave = false;          ///< Out of the room, by the way it came.
    bool unmarked_only = false;  ///< Enter only doorways without a mark.
    double beyond_m = 1.0;
  };
  explicit PassDoorway(const Config& config) : config_(config) {}
  void enter() override { passage_.reset(); }
  [[nodiscard]] BodyVec push(const Surroundings& around) override;

 private:
  /// In the odometry frame, so that it stays while the robot moves.
  struct Passage {
    OdometryVec middle_m;
    OdometryVec through;  ///< Across the doorway, length 1.
    double half_width_m = 0.0;
  };
  [[nodiscard]] std::optional<Passage> choose(const Surroundings& around) const;
  [[nodiscard]] std::optional<Passage> remembered(const Premises& here) const;
  /// Whether the way through `doorway` is `one_way`, and not the opposite.
  [[nodiscard]] bool goes(const OdometryVec& one_way, const SeenDoorway& doorway,
                          const Surroundings& around) const;
  [[nodiscard]] const SeenDoorway* pick(const Surroundings& around) const;

  Config config_;
  std::optional<Passage> passage_;
};

}  // namespace tacit
