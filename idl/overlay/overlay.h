#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace tacit {

/// Where something stands in a file, both from 1; 0 for what stands in none.
struct MapSpot {
  std::uint32_t line = 0;
  std::uint32_t column = 0;
  friend bool operator==(const MapSpot&, const MapSpot&) = default;
};

/// In the map's own frame: x east, y north.
struct MapPoint {
  double x_m = 0.0;
  double y_m = 0.0;
  friend bool operator==(const MapPoint&, const MapPoint&) = default;
};

enum class HeaderKind : std::uint8_t {
  Scenario,
  Site,
  Origin,
  GlobalRefPoint,
  Heading,
  MissionArea,
  LoadMap,
  HeightMap,
  Set,
  Scale,
  WaypointFile,
};

/// What a map says about itself: words, then numbers.
struct MapHeader {
  HeaderKind kind = HeaderKind::Scenario;
  std::vector<std::string> words;
  std::vector<double> numbers;
  friend bool operator==(const MapHeader&, const MapHeader&) = default;
};

/// The line "CONTROL MEASURES:".
struct MapMeasures {
  friend bool operator==(const MapMeasures&, const MapMeasures&) = default;
};

enum class ShapeKind : std::uint8_t {
  AssemblyArea,
  Attack,
  Axis,
  Boundary,
  BattlePosition,
  Gap,
  DepartureLine,
  Objective,
  PassagePoint,
  StartPoint,
  PhaseLine,
  Attractor,
  Basket,
  Wall,
  Room,
  Door,
  Zone,
};

/// A named point, line or area.
struct MapShape {
  ShapeKind kind = ShapeKind::Wall;
  std::string name;  ///< May be empty; one that ends in `*` is not to be shown.
  std::vector<MapPoint> points;
  std::optional<double> size_m;  ///< Radius of a point, width of a gap, height of a wall.
  friend bool operator==(const MapShape&, const MapShape&) = default;
};

/// A round obstacle.
struct MapObstacle {
  MapPoint centre;
  double radius_m = 0.0;
  std::optional<double> height_m;
  std::string name{};  ///< Some maps have one; most are empty.
  friend bool operator==(const MapObstacle&, const MapObstacle&) = default;
};

enum class Mobility : std::uint8_t { Fixed, Movable, Container };

/// A thing that robots can tell by its colour.
struct MapObject {
  MapPoint centre;
  double radius_m = 0.0;
  Mobility mobility = Mobility::Fixed;
  std::string colour;  ///< As the map spells it.
  friend bool operator==(const MapObject&, const MapObject&) = default;
};

struct MapHallway {
  std::string name;
  std::vector<MapPoint> centre_line;
  double width_m = 0.0;
  std::vector<MapPoint> outline;
  friend bool operator==(const MapHallway&, const MapHallway&) = default;
};

/// What nobody knows, or what had an error: only its text is kept.
struct MapUnknown {
  std::string text;
  friend bool operator==(const MapUnknown&, const MapUnknown&) = default;
};

using MapContent =
    std::variant<MapUnknown, MapHeader, MapMeasures, MapShape, MapObstacle, MapObject, MapHallway>;

/// One statement, with what a file had before and at it.
struct MapStatement {
  MapContent content;
  MapSpot at;
  std::string before;   ///< Blanks, ends of lines and comments since the statement before.
  std::string spelled;  ///< As the file has it; empty for a new statement.
};

/// A MissionLab overlay. Two are equal when their statements mean the same, however spelled.
struct OverlayMap {
  std::vector<MapStatement> statements;
  std::string ending;  ///< Blanks, ends of lines and comments after the last statement.
  friend bool operator==(const OverlayMap& a, const OverlayMap& b);
};

struct MapSize {
  double width_m = 0.0;
  double height_m = 0.0;
};

/// What the map's first MISSION-AREA says.
[[nodiscard]] std::optional<MapSize> mission_area(const OverlayMap& map);

/// Whether `name` is that of a start place; letters' case and a `*` at the end do not count.
[[nodiscard]] bool is_start_place(std::string_view name);
/// The first start place: a PP called StartPlace, or an SP.
[[nodiscard]] std::optional<MapPoint> start_place(const OverlayMap& map);

}  // namespace tacit
