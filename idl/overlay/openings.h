#pragma once

#include <optional>
#include <vector>

#include "idl/overlay/overlay.h"

namespace tacit {

struct MapSegment {
  MapPoint from;
  MapPoint to;
};

/// A door, which lies along a wall, or a gap, which leads through one.
struct MapOpening {
  enum class Kind : std::uint8_t { Door, Gap };
  Kind kind = Kind::Door;
  MapSegment place;      ///< From jamb to jamb, or the way through.
  double width_m = 0.0;  ///< Of a gap.
};

/// A part of a segment: distances from its beginning.
struct MapStretch {
  double from_m = 0.0;
  double to_m = 0.0;
};

/// So far from a wall's line a door still lies in it. [ours: double walls stand 0.1 m apart]
inline constexpr double kDoorReach_m = 0.15;
/// Of a gap that does not say. [ours: room for a robot]
inline constexpr double kGapWidth_m = 1.0;

[[nodiscard]] double length_m(const MapSegment& segment);

/// The door or gap that `shape` is; none when it is another thing.
[[nodiscard]] std::optional<MapOpening> opening_of(const MapShape& shape);

/// The part of `wall` that `opening` opens; none when it does not lie in it.
[[nodiscard]] std::optional<MapStretch> opened(const MapSegment& wall, const MapOpening& opening);

/// Whether `stretch` takes in all of `wall`.
[[nodiscard]] bool takes_all(const MapSegment& wall, const MapStretch& stretch);

/// What is left of `wall`.
[[nodiscard]] std::vector<MapSegment> without(const MapSegment& wall,
                                              std::vector<MapStretch> stretches);

/// The sides of a line, or of an area when `closed`, in order.
enum class Outline : std::uint8_t { Open, Closed };
[[nodiscard]] std::vector<MapSegment> sides(const std::vector<MapPoint>& points, Outline outline);

}  // namespace tacit
