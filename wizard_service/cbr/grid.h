#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "idl/overlay/ground.h"

namespace tacit::cbr {

/// Cells of a map with their clearance, and shortest ways over them. Places are in the world's
/// frame.
class Grid {
 public:
  /// `start` is where reachability counts from.
  Grid(const MapGround& ground, const MapPoint& start);

  [[nodiscard]] bool is_free(const MapPoint& place) const;
  [[nodiscard]] bool is_reachable(const MapPoint& place) const;
  [[nodiscard]] std::optional<MapPoint> nearest_reachable(const MapPoint& place) const;
  /// Through as few corners as clearance allows; empty when there is no way. Begins with `from` and
  /// ends with `to`, when both can be stood on.
  [[nodiscard]] std::vector<MapPoint> route(const MapPoint& from, const MapPoint& to) const;
  /// Whether nothing is within a metre of the straight line.
  [[nodiscard]] bool is_roomy(const MapPoint& from, const MapPoint& to) const;

 private:
  struct Cell {
    int x = 0;
    int y = 0;
  };

  [[nodiscard]] Cell cell_at(const MapPoint& place) const;
  [[nodiscard]] MapPoint middle(std::size_t index) const;
  [[nodiscard]] bool holds(const Cell& cell) const;
  [[nodiscard]] std::size_t index(const Cell& cell) const;
  [[nodiscard]] bool is_wide(std::size_t index) const;
  template <class Distance>
  void lower_clearance(const MapPoint& low, const MapPoint& high, const Distance& distance);
  void flood(const MapPoint& start);
  template <class Wanted>
  [[nodiscard]] std::optional<std::size_t> nearest(const MapPoint& place,
                                                   const Wanted& wanted) const;
  [[nodiscard]] std::optional<std::size_t> nearest_free(const MapPoint& place) const;
  [[nodiscard]] std::vector<std::size_t> path(std::size_t from, std::size_t to) const;
  [[nodiscard]] std::vector<std::size_t> corners(const std::vector<std::size_t>& path) const;
  [[nodiscard]] float clearance_between(const MapPoint& from, const MapPoint& to) const;

  double cell_m_;
  int columns_;
  int rows_;
  std::vector<float> clearance_m_;  ///< To the nearest wall or disc, at most kFar.
  std::vector<bool> reachable_;
};

}  // namespace tacit::cbr
