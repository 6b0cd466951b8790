#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "idl/overlay/plan.h"

namespace tacit::cbr {

/// What a planner knows of a map: where a robot can stand and how it gets from place to place. All
/// places are in the map's frame, as its file counts.
class Terrain {
 public:
  /// Borrows nothing. Throws ConfigError as `plan_of` does for a map that cannot be used.
  explicit Terrain(const OverlayMap& map, Doors doors = Doors::Open);
  ~Terrain();
  Terrain(Terrain&&) noexcept;
  Terrain& operator=(Terrain&&) noexcept;

  [[nodiscard]] const MapPlan& plan() const;
  /// Where the team starts.
  [[nodiscard]] MapPoint start() const;
  [[nodiscard]] bool holds(const MapPoint& place) const;
  /// Whether a robot can stand there.
  [[nodiscard]] bool is_free(const MapPoint& place) const;
  /// The nearest place where a robot can stand that can be reached from `from`; none when nothing
  /// can.
  [[nodiscard]] std::optional<MapPoint> nearest_reachable(const MapPoint& from,
                                                          const MapPoint& place) const;
  /// Places to go by in straight lines, without `from`, with `to` as the last; empty when there is
  /// no way.
  [[nodiscard]] std::vector<MapPoint> route(const MapPoint& from, const MapPoint& to) const;

  enum class Site { Open, Room, Hallway };
  [[nodiscard]] Site site(const MapPoint& place) const;
  /// The end of a hallway's centre line nearest to `place` by way from `from`; none on a map
  /// without hallways that can be reached.
  [[nodiscard]] std::optional<MapPoint> hallway_end(const MapPoint& from,
                                                    const MapPoint& place) const;

 private:
  class Grid;
  std::unique_ptr<Grid> grid_;
};

}  // namespace tacit::cbr
