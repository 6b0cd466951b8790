#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "idl/overlay/plan.h"

namespace tacit::cbr {

/// What a planner knows of a map: where a robot can stand and how it gets from place to place. All
/// places are in the map's frame, as its file counts.
///
/// Ways are looked for on a grid whose cells are 0.25 m wide, more on a map of more than 40,000 m²,
/// for a robot of 0.2 m radius that keeps 0.1 m away from walls and obstacles and prefers the
/// middle of what is narrow. [ours]
class Terrain {
 public:
  /// Borrows nothing. Throws ConfigError as `plan_of` does for a map that cannot be used.
  explicit Terrain(const OverlayMap& map, Doors doors = Doors::Open);
  ~Terrain();
  Terrain(Terrain&&) noexcept;
  Terrain& operator=(Terrain&&) noexcept;

  [[nodiscard]] const MapPlan& plan() const;
  [[nodiscard]] MapExtent extent() const;
  /// Where the team starts: the start place, the middle of a map without one.
  [[nodiscard]] MapPoint start() const;
  /// Whether it lies on the map.
  [[nodiscard]] bool holds(const MapPoint& place) const;
  /// Whether a robot can stand there.
  [[nodiscard]] bool is_free(const MapPoint& place) const;
  /// Where a robot can stand, nearest to `place`, that it can reach from the start; none when it
  /// can reach nothing.
  [[nodiscard]] std::optional<MapPoint> nearest_reachable(const MapPoint& place) const;
  [[nodiscard]] bool is_reachable(const MapPoint& place) const;
  /// Places to go by in straight lines, without `from`, with `to` as the last; empty when there is
  /// no way.
  [[nodiscard]] std::vector<MapPoint> route(const MapPoint& from, const MapPoint& to) const;

  /// Whether nothing is within a metre of the straight line.
  [[nodiscard]] bool is_roomy(const MapPoint& from, const MapPoint& to) const;

  /// Whether there is a hallway, so that there is a building to go through.
  [[nodiscard]] bool has_building() const;
  /// Whether it lies in a room or hallway.
  [[nodiscard]] bool in_building(const MapPoint& place) const;
  /// Where a robot that comes from `from` stands in the hallway nearest to `place`, `inside_m`
  /// along the way from where it comes in: `from` itself when that lies there. None on a map
  /// without hallways that can be reached.
  [[nodiscard]] std::optional<MapPoint> hallway_entry(const MapPoint& from, const MapPoint& place,
                                                      double inside_m) const;

 private:
  class Grid;
  [[nodiscard]] MapPoint to_world(const MapPoint& place) const;
  [[nodiscard]] MapPoint to_map(const MapPoint& place) const;
  [[nodiscard]] const MapHallway* hallway_nearest(const MapPoint& place) const;

  MapPlan plan_;
  std::unique_ptr<Grid> grid_;
};

}  // namespace tacit::cbr
