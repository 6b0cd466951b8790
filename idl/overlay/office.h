#pragma once

#include <cstdint>
#include <optional>

#include "idl/overlay/overlay.h"

namespace tacit {

/// What an office building is to have; what is left open is left to chance.
struct OfficeConfig {
  /// 2 to 8, on both sides of the hallway; else 4 to 8.
  std::optional<std::int64_t> rooms = {};
  /// So many of them without a door, fewer than all; else at most 2.
  std::optional<std::int64_t> closed_rooms = {};
  /// Suspect objects, 1 to the number of open rooms; else 2 or 3 if there are so many.
  std::optional<std::int64_t> suspects = {};
  /// A yard before the entry, and a sentry's way through yard and hallway.
  bool sentry = true;
  /// The start place on a lawn west of the building, and points "Way1", "Way2" and "Entry" from
  /// there to a way in at the hallway's west end.
  bool approach = false;
};

/// An office building by chance; the same seed and wishes give the same building. [ours]
///
/// A hallway runs from west to east, with rooms on both sides, "Room 1" and so on, those of the
/// south first. Every open room has a DOOR to the hallway. Suspect objects, brown, lie in open
/// rooms, one at most in each; exactly one of them is Movable, the others are Fixed. The start
/// place is at the hallway's west end, with a white object. With a sentry the hallway's east end is
/// a GAP into the yard, and the points "Sentry1" and so on are its way in order, a round trip.
///
/// All lengths are whole decimetres. `check` finds nothing in such a building. Throws ConfigError
/// when a wish is out of its range.
[[nodiscard]] OverlayMap random_office(std::uint64_t seed, const OfficeConfig& config);

}  // namespace tacit
