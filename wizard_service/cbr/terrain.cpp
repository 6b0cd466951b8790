#include "wizard_service/cbr/terrain.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "wizard_service/cbr/grid.h"
#include "wizard_service/cbr/places.h"

namespace tacit::cbr {
namespace {

MapPoint nearest_on(const MapPoint& p, const MapPoint& a, const MapPoint& b) {
  const double dx = b.x_m - a.x_m;
  const double dy = b.y_m - a.y_m;
  const double square = dx * dx + dy * dy;
  const double along =
      square == 0.0 ? 0.0
                    : std::clamp(((p.x_m - a.x_m) * dx + (p.y_m - a.y_m) * dy) / square, 0.0, 1.0);
  return {a.x_m + along * dx, a.y_m + along * dy};
}

MapPoint nearest_on_line(const MapPoint& p, const std::vector<MapPoint>& line) {
  MapPoint best = line.front();
  for (std::size_t i = 0; i + 1 < line.size(); ++i) {
    const MapPoint one = nearest_on(p, line[i], line[i + 1]);
    if (distance(p, one) < distance(p, best)) best = one;
  }
  return best;
}

MapPoint start_of(const MapPlan& plan) {
  return plan.ground.start.value_or(
      MapPoint{plan.ground.size.width_m / 2.0, plan.ground.size.height_m / 2.0});
}

}  // namespace

class Terrain::Grid : public cbr::Grid {
 public:
  using cbr::Grid::Grid;
};

Terrain::Terrain(const OverlayMap& map, Doors doors)
    : plan_(plan_of(map, doors)), grid_(std::make_unique<Grid>(plan_.ground, start_of(plan_))) {}
Terrain::~Terrain() = default;
Terrain::Terrain(Terrain&&) noexcept = default;
Terrain& Terrain::operator=(Terrain&&) noexcept = default;

const MapPlan& Terrain::plan() const { return plan_; }

MapPoint Terrain::to_world(const MapPoint& place) const {
  return {place.x_m + plan_.ground.shift_m.x_m, place.y_m + plan_.ground.shift_m.y_m};
}
MapPoint Terrain::to_map(const MapPoint& place) const {
  return {place.x_m - plan_.ground.shift_m.x_m, place.y_m - plan_.ground.shift_m.y_m};
}

MapExtent Terrain::extent() const {
  return {to_map({0.0, 0.0}), to_map({plan_.ground.size.width_m, plan_.ground.size.height_m})};
}

MapPoint Terrain::start() const { return to_map(start_of(plan_)); }

bool Terrain::holds(const MapPoint& place) const {
  const MapPoint p = to_world(place);
  return p.x_m >= 0.0 && p.y_m >= 0.0 && p.x_m <= plan_.ground.size.width_m &&
         p.y_m <= plan_.ground.size.height_m;
}

bool Terrain::is_free(const MapPoint& place) const { return grid_->is_free(to_world(place)); }
bool Terrain::is_reachable(const MapPoint& place) const {
  return grid_->is_reachable(to_world(place));
}

std::optional<MapPoint> Terrain::nearest_reachable(const MapPoint& place) const {
  if (is_reachable(place)) return place;
  const std::optional<MapPoint> found = grid_->nearest_reachable(to_world(place));
  return found ? std::optional(to_map(*found)) : std::nullopt;
}

std::vector<MapPoint> Terrain::route(const MapPoint& from, const MapPoint& to) const {
  std::vector<MapPoint> places = grid_->route(to_world(from), to_world(to));
  if (!places.empty()) places.erase(places.begin());
  for (MapPoint& place : places) place = to_map(place);
  return places;
}

bool Terrain::is_roomy(const MapPoint& from, const MapPoint& to) const {
  return grid_->is_roomy(to_world(from), to_world(to));
}

bool Terrain::has_building() const { return !plan_.halls.empty(); }

bool Terrain::in_building(const MapPoint& place) const {
  const MapPoint p = to_world(place);
  return room_at(plan_.rooms, p).has_value() ||
         std::any_of(plan_.halls.begin(), plan_.halls.end(),
                     [&](const MapHallway& hall) { return holds_point(hall.outline, p); });
}

const MapHallway* Terrain::hallway_nearest(const MapPoint& place) const {
  const MapHallway* best = nullptr;
  double least = std::numeric_limits<double>::infinity();
  for (const MapHallway& hall : plan_.halls) {
    const double far = distance(place, nearest_on_line(place, hall.centre_line));
    const bool open = std::any_of(hall.centre_line.begin(), hall.centre_line.end(),
                                  [&](const MapPoint& p) { return grid_->is_reachable(p); });
    if (open && far < least) {
      least = far;
      best = &hall;
    }
  }
  return best;
}

std::optional<MapPoint> Terrain::hallway_entry(const MapPoint& from, const MapPoint& place,
                                               double inside_m) const {
  const MapPoint begin = to_world(from);
  const MapHallway* hall = hallway_nearest(to_world(place));
  if (hall == nullptr) return std::nullopt;
  if (holds_point(hall->outline, begin)) return from;
  // The way to the middle of the hallway passes its entry.
  const MapPoint& a = hall->centre_line.front();
  const MapPoint& b = hall->centre_line.back();
  const MapPoint middle =
      nearest_on_line({(a.x_m + b.x_m) / 2.0, (a.y_m + b.y_m) / 2.0}, hall->centre_line);
  std::vector<MapPoint> way = grid_->route(begin, middle);
  if (way.empty()) return std::nullopt;
  double inside = 0.0;
  for (std::size_t i = 0; i + 1 < way.size(); ++i) {
    const double length = distance(way[i], way[i + 1]);
    constexpr double kStep = 0.1;
    for (double along = 0.0; along < length; along += kStep) {
      const double share = along / length;
      const MapPoint p{way[i].x_m + share * (way[i + 1].x_m - way[i].x_m),
                       way[i].y_m + share * (way[i + 1].y_m - way[i].y_m)};
      inside += holds_point(hall->outline, p) ? kStep : 0.0;
      if (inside >= inside_m) return to_map(nearest_on_line(p, hall->centre_line));
    }
  }
  return to_map(middle);
}

}  // namespace tacit::cbr
