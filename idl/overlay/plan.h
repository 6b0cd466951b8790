#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "idl/overlay/ground.h"
#include "idl/overlay/overlay.h"

namespace tacit {

/// A way through a wall, from jamb to jamb.
struct PlanDoor {
  std::string name;
  MapPoint from;
  MapPoint to;
  double width_m = 0.0;
  friend bool operator==(const PlanDoor&, const PlanDoor&) = default;
};

struct PlanRoom {
  std::string name;
  std::vector<MapPoint> outline;
  friend bool operator==(const PlanRoom&, const PlanRoom&) = default;
};

/// A named place: PP or SP.
struct PlanPoint {
  std::string name;
  MapPoint at;
  double radius_m = 0.0;
  friend bool operator==(const PlanPoint&, const PlanPoint&) = default;
};

/// A named area or line that is neither room nor wall, such as an assembly area.
struct PlanArea {
  ShapeKind kind = ShapeKind::AssemblyArea;
  std::string name;
  std::vector<MapPoint> points;
  double radius_m = 0.0;  ///< Of one that is a single point.
  friend bool operator==(const PlanArea&, const PlanArea&) = default;
};

/// What a mission needs to know of a map, all of it in the world's frame (see `MapGround`), names
/// without the `*` at the end, everything in the order of the file.
struct MapPlan {
  MapGround ground;               ///< Size, walls with openings cut out, discs, mines, start place.
  std::vector<PlanDoor> doors;    ///< DOOR.
  std::vector<PlanDoor> gaps;     ///< GAP; `from` and `to` are the jambs here as well.
  std::vector<PlanRoom> rooms;    ///< ROOM.
  std::vector<MapHallway> halls;  ///< HALLWAY: name, centre line, width, outline.
  std::vector<PlanPoint> points;  ///< PP, SP.
  std::vector<PlanArea> areas;    ///< AA, OBJ, AXIS, ... : the shapes that are none of the above.
  std::vector<MapObject> objects;  ///< OBJECT, discs and mines included.
};

/// Throws ConfigError as `ground_of` does.
[[nodiscard]] MapPlan plan_of(const OverlayMap& map, Doors doors);

/// Whether `p` lies in `outline` or on its rim.
[[nodiscard]] bool holds_point(const std::vector<MapPoint>& outline, const MapPoint& p);

/// The index of the first of `rooms` that holds `p`.
[[nodiscard]] std::optional<std::size_t> room_at(const std::vector<PlanRoom>& rooms,
                                                 const MapPoint& p);

}  // namespace tacit
