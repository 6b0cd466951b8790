#pragma once

#include <algorithm>
#include <cmath>
#include <string_view>

#include "robot_agent/brain/perception/surroundings.h"

namespace tacit {

/// Whether the robot stands in an open doorway, half in one place and half in another [ours: a
/// body's length, so that a robot that is said to be in a room has left the doorway].
[[nodiscard]] inline bool in_a_doorway(const Premises& here) {
  constexpr double kClearM = 0.4;
  return std::any_of(here.doorways.begin(), here.doorways.end(), [](const SeenDoorway& each) {
    const BodyVec across = unit(BodyVec{-each.jamb_m.y(), each.jamb_m.x()});
    const bool between_jambs = std::abs(each.offset_m.dot(unit(each.jamb_m))) <= each.jamb_m.norm();
    return between_jambs && std::abs(each.offset_m.dot(across)) < kClearM;
  });
}

/// Fires while the robot is in a room, and clear of its doorway.
struct InRoom {
  static constexpr std::string_view kName = "InRoom";

  [[nodiscard]] bool holds(const Surroundings& around) const {
    return around.premises.site == Site::Room && !in_a_doorway(around.premises);
  }
};

/// Fires while the robot is in a hallway, and clear of its doorways.
struct InHallway {
  static constexpr std::string_view kName = "InHallway";

  [[nodiscard]] bool holds(const Surroundings& around) const {
    return around.premises.site == Site::Hallway && !in_a_doorway(around.premises);
  }
};

/// The way along the hallway that the robot is in, as its course has it, else as it faces.
[[nodiscard]] inline BodyVec hallway_way(const Surroundings& around) {
  const Premises& here = around.premises;
  const BodyVec course =
      here.course ? to_body(around.odometry.heading, *here.course) : BodyVec{1.0, 0.0};
  return course.dot(here.hallway->along) >= 0.0 ? here.hallway->along : -here.hallway->along;
}

/// Fires where the hallway that the robot is in ends, in the direction in which it goes.
struct AtEndOfHall {
  static constexpr std::string_view kName = "AtEndOfHall";
  double tolerance_m = 0.5;

  [[nodiscard]] bool holds(const Surroundings& around) const {
    const Premises& here = around.premises;
    if (!here.hallway) return false;
    const bool ahead = hallway_way(around).dot(here.hallway->along) >= 0.0;
    return (ahead ? here.hallway->ahead_m : here.hallway->behind_m) <= tolerance_m;
  }
};

struct NotAtEndOfHall {
  static constexpr std::string_view kName = "NotAtEndOfHall";
  double tolerance_m = 0.5;

  [[nodiscard]] bool holds(const Surroundings& around) const {
    return !AtEndOfHall{tolerance_m}.holds(around);
  }
};

/// On which side of the robot.
enum class Side : std::uint8_t { Left, Right, Either };

/// Fires in a hallway beside the middle of a doorway, left and right being those of a robot that
/// goes its way along the hallway.
struct AtDoorway {
  static constexpr std::string_view kName = "AtDoorway";
  Side side = Side::Either;
  bool unmarked_only = true;
  double clearance_m = 0.5;      ///< As far before the middle as behind it, together.
  double hallway_width_m = 2.0;  ///< A doorway farther off is not this hallway's.

  [[nodiscard]] bool holds(const Surroundings& around) const {
    const Premises& here = around.premises;
    if (here.site != Site::Hallway || !here.hallway) return false;
    const BodyVec way = hallway_way(around);
    return std::any_of(here.doorways.begin(), here.doorways.end(),
                       [&](const SeenDoorway& each) { return beside(each, way); });
  }

 private:
  [[nodiscard]] bool beside(const SeenDoorway& doorway, const BodyVec& way) const {
    if (unmarked_only && doorway.marked) return false;
    if (std::abs(way.dot(doorway.offset_m)) > 0.5 * clearance_m) return false;
    const double left_m = way.cross(doorway.offset_m);
    if (std::abs(left_m) > hallway_width_m) return false;
    const bool left = left_m > 0.0;
    return side == Side::Either || (side == Side::Left) == left;
  }
};

/// Fires when the robot has put a mark on a doorway, or taken it off.
struct MarkedDoorway {
  static constexpr std::string_view kName = "MarkedDoorway";

  [[nodiscard]] bool holds(const Surroundings& around) const { return around.deeds.marked; }
};

}  // namespace tacit
