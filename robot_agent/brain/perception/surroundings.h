#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "idl/types/percept.h"

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

/// A percept made ready for thinking: sorted by kind, measured, and completed by memory.
///
/// Valid until the next percept; the order of the lists carries no meaning.
struct Surroundings {
  Tick tick = 0;
  OdometryPose odometry;
  std::optional<BodyVec> target_m;  ///< Seen or remembered; empty until first seen.
  std::vector<Seen> teammates;
  std::vector<Seen> enemies;
  std::vector<EnemyGroup> groups;
  /// The nearest of `groups` that is open, that is, not occluded by a teammate; null when there
  /// is none.
  const EnemyGroup* open_group = nullptr;
  std::span<const SeenObstacle> obstacles;
};

/// Whether `a` is nearer than `b`. Equal ranges are told apart by position, so that the answer to
/// "which is nearest?" does not hang on the order of a list.
[[nodiscard]] inline bool nearer(const Seen& a, const Seen& b) {
  if (a.range_m != b.range_m) return a.range_m < b.range_m;
  if (a.offset_m.x() != b.offset_m.x()) return a.offset_m.x() < b.offset_m.x();
  return a.offset_m.y() < b.offset_m.y();
}

}  // namespace tacit
