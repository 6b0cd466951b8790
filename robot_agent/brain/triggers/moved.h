#pragma once

#include <algorithm>
#include <cstddef>
#include <string_view>

#include "robot_agent/brain/fsa/entry.h"
#include "robot_agent/brain/perception/surroundings.h"

namespace tacit {

/// Fires once the robot is so far from where its state was entered.
struct MovedDistance {
  static constexpr std::string_view kName = "MovedDistance";
  double distance_m = 1.0;
  OdometryVec from_m;  ///< Where the state was entered.

  void entered(const Entry& entry) { from_m = entry.pose.position_m; }
  [[nodiscard]] bool holds(const Surroundings& around) const {
    return (around.odometry.position_m - from_m).norm() >= distance_m;
  }
};

/// Fires once the robot has turned by this much since its state was entered, either way, at most
/// half a turn.
struct HasTurned {
  static constexpr std::string_view kName = "HasTurned";
  double angle_deg = 90.0;
  Heading from;  ///< When the state was entered.

  void entered(const Entry& entry) { from = entry.pose.heading; }
  [[nodiscard]] bool holds(const Surroundings& around) const {
    const Heading& now = around.odometry.heading;
    const double cos = from.cos * now.cos + from.sin * now.sin;
    return cos <= sin_cos(std::min(angle_deg, 180.0) * kPi / 180.0).cos + 1e-9;
  }
};

/// Fires once the robot faces against where it faced when its state was entered, give or take 5
/// degrees [ours].
struct AboutFaceCompleted {
  static constexpr std::string_view kName = "AboutFaceCompleted";
  HasTurned turned{175.0, {}};

  void entered(const Entry& entry) { turned.entered(entry); }
  [[nodiscard]] bool holds(const Surroundings& around) const { return turned.holds(around); }
};

/// Fires while the robot, for `ticks` or more in its state, is no farther than `distance_m` from
/// where it was `ticks` ago.
struct NoProgress {
  static constexpr std::string_view kName = "NoProgress";
  double distance_m = 0.1;
  Tick ticks = 50;
  Tick since = 0;  ///< When the state was entered.

  void entered(const Entry& entry) { since = entry.tick; }
  [[nodiscard]] bool holds(const Surroundings& around) const {
    const auto& track = around.premises.track;
    if (around.tick < since + ticks || track.size() <= ticks) return false;
    return (track[ticks] - track[0]).norm() <= distance_m;
  }
};

}  // namespace tacit
