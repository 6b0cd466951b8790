#pragma once

#include <array>
#include <cstddef>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "idl/types/percept.h"
#include "robot_agent/brain/perception/place_memory.h"
#include "robot_agent/brain/perception/premises.h"
#include "robot_agent/brain/perception/quarry_track.h"
#include "robot_agent/brain/perception/thing.h"

namespace tacit {

/// A teammate or an enemy, with its range worked out once for all who ask.
struct Seen {
  BodyVec offset_m;
  double range_m = 0.0;
  bool able = true;  ///< False for a teammate painted as disabled.
};

/// Enemies that hang together, as far as they are in sight; `size` >= 1.
struct EnemyGroup {
  std::size_t size = 0;
  BodyVec centroid_m;
  Seen nearest;  ///< The member nearest to this robot.
};

/// The nearest thing of a class; infinitely far while none is known.
struct Nearest {
  BodyVec offset_m;
  double squared_range_m2 = std::numeric_limits<double>::infinity();
  double radius_m = 0.0;

  [[nodiscard]] bool known() const {
    return squared_range_m2 < std::numeric_limits<double>::infinity();
  }
  /// Centre to centre.
  [[nodiscard]] bool within(double range_m) const { return squared_range_m2 <= range_m * range_m; }
  /// From the robot's centre to the thing's surface.
  [[nodiscard]] bool surface_within(double range_m) const {
    return known() && within(range_m + radius_m);
  }
};

/// Whether `a` is nearer than `b`. Equal ranges are told apart by position, so that the order of
/// the sightings does not matter.
[[nodiscard]] inline bool nearer(const Nearest& a, const Nearest& b) {
  if (a.squared_range_m2 != b.squared_range_m2) return a.squared_range_m2 < b.squared_range_m2;
  if (a.offset_m.x() != b.offset_m.x()) return a.offset_m.x() < b.offset_m.x();
  return a.offset_m.y() < b.offset_m.y();
}

/// A percept made ready for thinking: sorted by kind, measured, and completed by memory.
///
/// Valid until the next percept; the order of the lists carries no meaning. A guard's, a forager's
/// and an operation's perception each fill their part and leave the rest empty.
struct Surroundings {
  Tick tick = 0;
  OdometryPose odometry;
  std::span<const SeenObstacle> obstacles;
  std::vector<Seen> teammates;  ///< A forager's: the able ones in reach.

  // A guard's.
  std::optional<BodyVec> target_m;  ///< Seen or remembered; empty until first seen.
  std::vector<Seen> enemies;
  std::vector<EnemyGroup> groups;
  /// The nearest of `groups` that is open, that is, not occluded by a teammate; null when there
  /// is none.
  const EnemyGroup* open_group = nullptr;

  // A forager's.
  bool able = true;
  bool holding = false;
  Deeds deeds;
  std::array<Nearest, kThings> nearest;
  std::optional<QuarryTrack::Motion> quarry;  ///< Of the nearest enemy, while there is a track.

  // An operation's, beside the forager's.
  Premises premises;

  /// Takes over what needs no sorting; borrows from `percept`.
  void take(const Percept& percept) {
    tick = percept.tick;
    odometry = percept.odometry;
    obstacles = percept.obstacles;
    able = percept.able;
    holding = percept.holding;
    deeds = percept.deeds;
  }
  /// Takes in that a thing was seen.
  void note(Thing thing, const Nearest& seen) {
    Nearest& best = nearest[static_cast<std::size_t>(thing)];
    if (nearer(seen, best)) best = seen;
  }
  /// Lets `memory` learn where a thing that stays where it is was seen, or say where it must be.
  void complete(Thing thing, PlaceMemory& memory) {
    Nearest& known = nearest[static_cast<std::size_t>(thing)];
    if (known.known()) {
      memory.see(odometry, known.offset_m);
    } else if (const auto remembered_m = memory.from(odometry)) {
      known = {*remembered_m, remembered_m->squared_norm()};
    }
  }

  [[nodiscard]] const Nearest& nearest_of(Thing thing) const {
    return nearest[static_cast<std::size_t>(thing)];
  }
  [[nodiscard]] const Nearest& nearest_of(ThingSet things) const {
    static const Nearest kNone{};
    const Nearest* best = &kNone;
    things.for_each([&](std::size_t index) {
      if (nearer(nearest[index], *best)) best = &nearest[index];
    });
    return *best;
  }
};

/// Whether `a` is nearer than `b`. Equal ranges are told apart by position, so that the answer to
/// "which is nearest?" does not hang on the order of a list.
[[nodiscard]] inline bool nearer(const Seen& a, const Seen& b) {
  if (a.range_m != b.range_m) return a.range_m < b.range_m;
  if (a.offset_m.x() != b.offset_m.x()) return a.offset_m.x() < b.offset_m.x();
  return a.offset_m.y() < b.offset_m.y();
}

}  // namespace tacit
