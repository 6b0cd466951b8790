#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include "idl/overlay/plan.h"

namespace tacit {

inline double distance_m(const MapSegment& wall, const MapPoint& p) {
  const double length = length_m(wall);
  const double dx = (wall.to.x_m - wall.from.x_m) / length;
  const double dy = (wall.to.y_m - wall.from.y_m) / length;
  const double along =
      std::clamp((p.x_m - wall.from.x_m) * dx + (p.y_m - wall.from.y_m) * dy, 0.0, length);
  return length_m({p, {wall.from.x_m + along * dx, wall.from.y_m + along * dy}});
}

/// Where a body of radius `kBody_m` that begins at the start place can get to, in steps so small
/// that none leaps a wall.
class Flood {
 public:
  static constexpr double kBody_m = 0.25;

  explicit Flood(const MapPlan& plan)
      : plan_(plan),
        columns_(1 + index(plan.ground.size.width_m)),
        seen_(columns_ * (1 + index(plan.ground.size.height_m))) {
    enter(cell_of(*plan.ground.start));
    for (std::size_t next = 0; next < reached_.size(); ++next) {
      const auto [i, j] = reached_[next];
      enter({i + 1, j});
      enter({i, j + 1});
      if (i > 0) enter({i - 1, j});
      if (j > 0) enter({i, j - 1});
    }
  }

  [[nodiscard]] bool reaches(const MapPoint& p) const {
    return std::any_of(reached_.begin(), reached_.end(), [&](const Cell& cell) {
      return length_m({place(cell), p}) < kStep_m;
    });
  }

  [[nodiscard]] bool reaches(const PlanRoom& room) const {
    return std::any_of(reached_.begin(), reached_.end(),
                       [&](const Cell& cell) { return holds_point(room.outline, place(cell)); });
  }

 private:
  using Cell = std::pair<std::size_t, std::size_t>;
  static constexpr double kStep_m = 0.3;

  static std::size_t index(double length_m) {
    return static_cast<std::size_t>(std::max(0.0, std::floor(length_m / kStep_m)));
  }
  static Cell cell_of(const MapPoint& p) { return {index(p.x_m), index(p.y_m)}; }
  static MapPoint place(const Cell& cell) {
    return {kStep_m * static_cast<double>(cell.first), kStep_m * static_cast<double>(cell.second)};
  }

  void enter(const Cell& cell) {
    const std::size_t at = cell.second * columns_ + cell.first;
    if (cell.first >= columns_ || at >= seen_.size() || seen_[at] != 0) return;
    seen_[at] = 1;
    if (is_free(place(cell))) reached_.push_back(cell);
  }

  [[nodiscard]] bool is_free(const MapPoint& p) const {
    const auto& discs = plan_.ground.discs;
    return std::all_of(plan_.ground.walls.begin(), plan_.ground.walls.end(),
                       [&](const MapSegment& wall) { return distance_m(wall, p) > kBody_m; }) &&
           std::all_of(discs.begin(), discs.end(), [&](const std::vector<double>& disc) {
             return length_m({{disc[0], disc[1]}, p}) > disc[2] + kBody_m;
           });
  }

  const MapPlan& plan_;
  std::size_t columns_;
  std::vector<char> seen_;
  std::vector<Cell> reached_;
};

/// Whether a door lies in a side of `room`.
inline bool has_door(const MapPlan& plan, const PlanRoom& room) {
  return std::any_of(plan.doors.begin(), plan.doors.end(), [&room](const PlanDoor& door) {
    return holds_point(room.outline, door.from) && holds_point(room.outline, door.to);
  });
}

}  // namespace tacit
