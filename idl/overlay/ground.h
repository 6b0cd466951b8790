#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "idl/overlay/openings.h"
#include "idl/overlay/overlay.h"

namespace tacit {

/// How doors stand.
enum class Doors : std::uint8_t { Open, Closed };

/// What a world is built from. Its frame: origin at the south-west corner of the area.
struct MapGround {
  MapSize size;
  MapPoint shift_m;  ///< To be added to a place on the map.
  std::vector<MapSegment> walls;
  std::vector<std::vector<double>> discs;  ///< Rows of x, y, r.
  std::vector<std::vector<double>> mines;  ///< Rows of x, y.
  std::optional<MapPoint> start;
};

/// What is compared pair by pair may make so many; about a second's work. [ours]
inline constexpr std::size_t kMostPairs = 400'000'000;

/// The kind of line that makes the map's walls: WALL if there is one, else ROOM, else BOUNDARY.
///
/// A map with WALLs draws its rooms' sides with them, gaps left out, and means ROOM as the area
/// between; a map without has the rooms' outlines alone; plans turned into overlays by a program
/// have nothing but BOUNDARY. A hallway's outline is never a wall: hallways cross, and open into
/// one another. [ours: read off MissionLab's own maps]
[[nodiscard]] ShapeKind wall_kind(const OverlayMap& map);

/// The walls as the map has them, doors and gaps cut out, in the map's frame.
///
/// A DOOR opens the walls in whose line it lies; one that is closed stands as a wall. A GAP opens
/// the walls that it leads through. A wall that lies whole in an opening goes, even if it was drawn
/// to shut it; `check` tells of it.
///
/// Throws ConfigError when there are more than `kMostPairs` pairs of a wall and an opening.
[[nodiscard]] std::vector<MapSegment> walls_of(const OverlayMap& map, Doors doors);

/// A rectangle on the map.
struct MapExtent {
  MapPoint low;
  MapPoint high;
};
/// Takes in the area and everything on the map; 2 m by 2 m at 0, 0 when there is nothing.
[[nodiscard]] MapExtent extent_of(const OverlayMap& map);

/// The area is MISSION-AREA, in which a map counts from the south-west corner (ORIGIN is not used);
/// without one it is the bounding box of all places with 1 m around. Walls are cut off at its
/// border; what lies outside is left out. Discs are OBSTACLEs and the fixed OBJECTs that are black
/// (rocks) or DarkSeaGreen (trees); mines are movable orange OBJECTs that lie in no disc.
///
/// Throws ConfigError as `walls_of` does, and for as many pairs of a mine and a disc.
[[nodiscard]] MapGround ground_of(const OverlayMap& map, Doors doors);

}  // namespace tacit
