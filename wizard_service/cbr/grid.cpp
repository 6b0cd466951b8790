#include "wizard_service/cbr/grid.h"

#include <algorithm>
#include <cmath>
#include <queue>
#include <utility>

#include "wizard_service/cbr/places.h"

namespace tacit::cbr {
namespace {

/// Radius of a robot and what it keeps away at least.
constexpr double kClear = 0.3;
/// From here on clearance makes no difference.
constexpr double kFar = 1.0;
/// What a way that is cut short keeps, if the way as found has it.
constexpr float kComfortable = 0.6F;
constexpr double kFinest = 0.25;
constexpr double kMostCells = 640'000.0;

double distance_to(const MapSegment& wall, const MapPoint& p) {
  const double dx = wall.to.x_m - wall.from.x_m;
  const double dy = wall.to.y_m - wall.from.y_m;
  const double square = dx * dx + dy * dy;
  const double along =
      square == 0.0
          ? 0.0
          : std::clamp(((p.x_m - wall.from.x_m) * dx + (p.y_m - wall.from.y_m) * dy) / square, 0.0,
                       1.0);
  return distance(p, MapPoint{wall.from.x_m + along * dx, wall.from.y_m + along * dy});
}

/// Of a step of length 1 through a cell: twice as much close to a wall as in the open.
float price(float clearance_m) {
  constexpr float kFarthest = static_cast<float>(kFar);
  return 1.0F + 1.5F * (kFarthest - std::min(clearance_m, kFarthest));
}

struct Open {
  float estimate = 0.0F;
  std::size_t cell = 0;
};
struct Dearer {
  bool operator()(const Open& a, const Open& b) const {
    return a.estimate != b.estimate ? a.estimate > b.estimate : a.cell > b.cell;
  }
};

constexpr std::pair<int, int> kSteps[] = {{1, 0}, {-1, 0}, {0, 1},  {0, -1},
                                          {1, 1}, {1, -1}, {-1, 1}, {-1, -1}};

}  // namespace

Grid::Grid(const MapGround& ground, const MapPoint& start)
    : cell_m_(
          std::max(kFinest, std::sqrt(ground.size.width_m * ground.size.height_m / kMostCells))),
      columns_(std::max(1, static_cast<int>(std::ceil(ground.size.width_m / cell_m_)))),
      rows_(std::max(1, static_cast<int>(std::ceil(ground.size.height_m / cell_m_)))),
      clearance_m_(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_),
                   static_cast<float>(kFar)) {
  for (std::size_t i = 0; i < clearance_m_.size(); ++i) {
    const MapPoint p = middle(i);
    const double edge = std::min(std::min(p.x_m, ground.size.width_m - p.x_m),
                                 std::min(p.y_m, ground.size.height_m - p.y_m));
    clearance_m_[i] = std::min(clearance_m_[i], static_cast<float>(std::max(edge, 0.0)));
  }
  for (const MapSegment& wall : ground.walls) {
    lower_clearance({std::min(wall.from.x_m, wall.to.x_m), std::min(wall.from.y_m, wall.to.y_m)},
                    {std::max(wall.from.x_m, wall.to.x_m), std::max(wall.from.y_m, wall.to.y_m)},
                    [&](const MapPoint& p) { return distance_to(wall, p); });
  }
  for (const std::vector<double>& disc : ground.discs) {
    const MapPoint centre{disc[0], disc[1]};
    lower_clearance({disc[0] - disc[2], disc[1] - disc[2]}, {disc[0] + disc[2], disc[1] + disc[2]},
                    [&](const MapPoint& p) { return distance(p, centre) - disc[2]; });
  }
  flood(start);
}

template <class Distance>
void Grid::lower_clearance(const MapPoint& low, const MapPoint& high, const Distance& distance) {
  const Cell first = cell_at({low.x_m - kFar, low.y_m - kFar});
  const Cell last = cell_at({high.x_m + kFar, high.y_m + kFar});
  for (int y = std::max(first.y, 0); y <= std::min(last.y, rows_ - 1); ++y) {
    for (int x = std::max(first.x, 0); x <= std::min(last.x, columns_ - 1); ++x) {
      const std::size_t at = index({x, y});
      const auto here = static_cast<float>(std::max(distance(middle(at)), 0.0));
      clearance_m_[at] = std::min(clearance_m_[at], here);
    }
  }
}

Grid::Cell Grid::cell_at(const MapPoint& place) const {
  const auto step = [&](double along, int most) {
    return static_cast<int>(
        std::clamp(std::floor(along / cell_m_), -1.0, static_cast<double>(most)));
  };
  return {step(place.x_m, columns_), step(place.y_m, rows_)};
}

MapPoint Grid::middle(std::size_t index) const {
  const auto columns = static_cast<std::size_t>(columns_);
  return {(static_cast<double>(index % columns) + 0.5) * cell_m_,
          (static_cast<double>(index / columns) + 0.5) * cell_m_};
}

bool Grid::holds(const Cell& cell) const {
  return cell.x >= 0 && cell.y >= 0 && cell.x < columns_ && cell.y < rows_;
}

std::size_t Grid::index(const Cell& cell) const {
  return static_cast<std::size_t>(cell.y) * static_cast<std::size_t>(columns_) +
         static_cast<std::size_t>(cell.x);
}

bool Grid::is_wide(std::size_t index) const {
  return clearance_m_[index] >= static_cast<float>(kClear);
}

bool Grid::is_free(const MapPoint& place) const {
  const Cell cell = cell_at(place);
  return holds(cell) && is_wide(index(cell));
}

bool Grid::is_reachable(const MapPoint& place) const {
  const Cell cell = cell_at(place);
  return holds(cell) && reachable_[index(cell)];
}

void Grid::flood(const MapPoint& start) {
  reachable_.assign(clearance_m_.size(), false);
  const std::optional<std::size_t> first = nearest_free(start);
  if (!first) return;
  std::vector<std::size_t> open{*first};
  reachable_[*first] = true;
  while (!open.empty()) {
    const std::size_t at = open.back();
    open.pop_back();
    const Cell here{static_cast<int>(at % static_cast<std::size_t>(columns_)),
                    static_cast<int>(at / static_cast<std::size_t>(columns_))};
    for (const auto& [dx, dy] : {kSteps[0], kSteps[1], kSteps[2], kSteps[3]}) {
      const Cell next{here.x + dx, here.y + dy};
      if (!holds(next) || !is_wide(index(next)) || reachable_[index(next)]) continue;
      reachable_[index(next)] = true;
      open.push_back(index(next));
    }
  }
}

/// Looks in squares around the place, each a cell wider than the one before, until whatever lies
/// further out is further away. Of equally near cells the first.
template <class Wanted>
std::optional<std::size_t> Grid::nearest(const MapPoint& place, const Wanted& wanted) const {
  const Cell centre = cell_at(place);
  std::optional<std::size_t> best;
  double least = 0.0;
  const auto look = [&](const Cell& cell) {
    const std::size_t at = index(cell);
    if (!wanted(at)) return;
    const double far = distance(middle(at), place);
    if (best && (far > least || (far == least && at > *best))) return;
    best = at;
    least = far;
  };
  for (int ring = 0; ring <= columns_ + rows_; ++ring) {
    if (best && least < (ring - 0.5) * cell_m_) break;
    const int left = centre.x - ring;
    const int right = centre.x + ring;
    for (int y = std::max(centre.y - ring, 0); y <= std::min(centre.y + ring, rows_ - 1); ++y) {
      const bool whole = y == centre.y - ring || y == centre.y + ring;
      for (int x = std::max(left, 0); x <= std::min(right, columns_ - 1); ++x) {
        // Of a row in between only its ends.
        if (!whole && x > left && x < right) {
          x = right - 1;
          continue;
        }
        look({x, y});
      }
    }
  }
  return best;
}

std::optional<std::size_t> Grid::nearest_free(const MapPoint& place) const {
  return nearest(place, [this](std::size_t cell) { return is_wide(cell); });
}

std::optional<MapPoint> Grid::nearest_reachable(const MapPoint& place) const {
  const std::optional<std::size_t> cell =
      nearest(place, [this](std::size_t at) { return static_cast<bool>(reachable_[at]); });
  if (!cell) return std::nullopt;
  return middle(*cell);
}

std::vector<std::size_t> Grid::path(std::size_t from, std::size_t to) const {
  const auto columns = static_cast<std::size_t>(columns_);
  const MapPoint goal = middle(to);
  constexpr std::size_t kNone = static_cast<std::size_t>(-1);
  std::vector<std::size_t> before(clearance_m_.size(), kNone);
  std::vector<float> cost(clearance_m_.size(), -1.0F);
  std::priority_queue<Open, std::vector<Open>, Dearer> open;
  cost[from] = 0.0F;
  open.push({0.0F, from});
  while (!open.empty() && open.top().cell != to) {
    const std::size_t at = open.top().cell;
    const float estimate = open.top().estimate;
    open.pop();
    const auto left = [&](std::size_t cell) {
      return static_cast<float>(distance(middle(cell), goal) / cell_m_);
    };
    if (estimate > cost[at] + left(at) + 1e-3F && at != from) continue;
    const Cell here{static_cast<int>(at % columns), static_cast<int>(at / columns)};
    for (const auto& [dx, dy] : kSteps) {
      const Cell next{here.x + dx, here.y + dy};
      if (!holds(next) || !is_wide(index(next))) continue;
      // Not between two corners.
      if (dx != 0 && dy != 0 &&
          (!is_wide(index({here.x + dx, here.y})) || !is_wide(index({here.x, here.y + dy})))) {
        continue;
      }
      const float length = dx != 0 && dy != 0 ? 1.41421356F : 1.0F;
      const std::size_t there = index(next);
      const float total = cost[at] + length * price(clearance_m_[there]);
      if (cost[there] >= 0.0F && cost[there] <= total) continue;
      cost[there] = total;
      before[there] = at;
      open.push({total + left(there), there});
    }
  }
  std::vector<std::size_t> cells;
  if (cost[to] < 0.0F) return cells;
  for (std::size_t at = to; at != kNone; at = before[at]) cells.push_back(at);
  std::reverse(cells.begin(), cells.end());
  return cells;
}

float Grid::clearance_between(const MapPoint& from, const MapPoint& to) const {
  const int steps = std::max(1, static_cast<int>(std::ceil(2.0 * distance(from, to) / cell_m_)));
  float least = static_cast<float>(kFar);
  for (int i = 0; i <= steps; ++i) {
    const double share = static_cast<double>(i) / steps;
    const Cell cell =
        cell_at({from.x_m + share * (to.x_m - from.x_m), from.y_m + share * (to.y_m - from.y_m)});
    if (!holds(cell)) return 0.0F;
    least = std::min(least, clearance_m_[index(cell)]);
  }
  return least;
}

bool Grid::is_roomy(const MapPoint& from, const MapPoint& to) const {
  return clearance_between(from, to) >= static_cast<float>(kFar);
}

std::vector<std::size_t> Grid::corners(const std::vector<std::size_t>& path) const {
  std::vector<std::size_t> kept{path.front()};
  std::size_t at = 0;
  while (at + 1 < path.size()) {
    std::size_t next = at + 1;
    float narrowest = std::min(kComfortable, clearance_m_[path[at]]);
    for (std::size_t i = at + 1; i < path.size(); ++i) {
      narrowest = std::min(narrowest, clearance_m_[path[i]]);
      if (clearance_between(middle(path[at]), middle(path[i])) >= narrowest) next = i;
    }
    at = next;
    kept.push_back(path[at]);
  }
  return kept;
}

std::vector<MapPoint> Grid::route(const MapPoint& from, const MapPoint& to) const {
  const std::optional<std::size_t> first = nearest_free(from);
  const std::optional<std::size_t> last = nearest_free(to);
  if (!first || !last) return {};
  std::vector<MapPoint> places{middle(*first), middle(*last)};
  // What is comfortable straight on has no corner, whatever way would be found.
  if (*first == *last || clearance_between(places.front(), places.back()) < kComfortable) {
    const std::vector<std::size_t> cells = path(*first, *last);
    if (cells.empty()) return {};
    places.clear();
    for (const std::size_t cell : corners(cells)) places.push_back(middle(cell));
  }
  if (is_free(from)) places.front() = from;
  if (is_free(to)) {
    if (places.size() == 1) places.push_back(to);
    places.back() = to;
  }
  return places;
}

}  // namespace tacit::cbr
