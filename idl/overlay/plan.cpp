#include "idl/overlay/plan.h"

#include <algorithm>
#include <cmath>

#include "idl/overlay/openings.h"

namespace tacit {
namespace {

std::string without_star(std::string name) {
  if (name.ends_with('*')) name.pop_back();
  return name;
}

/// Takes the statements in, moved into the world's frame.
class Planner {
 public:
  explicit Planner(MapGround ground) { plan_.ground = std::move(ground); }

  void operator()(const MapUnknown& /*unknown*/) {}
  void operator()(const MapHeader& /*header*/) {}
  void operator()(const MapMeasures& /*measures*/) {}
  void operator()(const MapObstacle& /*obstacle*/) {}

  void operator()(MapObject object) {
    object.centre = moved(object.centre);
    plan_.objects.push_back(std::move(object));
  }

  void operator()(MapHallway hallway) {
    hallway.name = without_star(std::move(hallway.name));
    hallway.centre_line = moved(std::move(hallway.centre_line));
    hallway.outline = moved(std::move(hallway.outline));
    plan_.halls.push_back(std::move(hallway));
  }

  void operator()(MapShape shape) {
    shape.name = without_star(std::move(shape.name));
    shape.points = moved(std::move(shape.points));
    switch (shape.kind) {
      case ShapeKind::Wall:
      case ShapeKind::Boundary:
        break;  // They are in the ground, as far as they are built.
      case ShapeKind::Door:
        plan_.doors.push_back(door(shape.name, {shape.points.at(0), shape.points.at(1)}));
        break;
      case ShapeKind::Gap:
        plan_.gaps.push_back(gap(shape));
        break;
      case ShapeKind::Room:
        plan_.rooms.push_back({std::move(shape.name), std::move(shape.points)});
        break;
      case ShapeKind::PassagePoint:
      case ShapeKind::StartPoint:
        plan_.points.push_back(
            {std::move(shape.name), shape.points.at(0), shape.size_m.value_or(0.0)});
        break;
      default:
        plan_.areas.push_back({shape.kind, std::move(shape.name), std::move(shape.points),
                               shape.size_m.value_or(0.0)});
    }
  }

  MapPlan take() { return std::move(plan_); }

 private:
  [[nodiscard]] MapPoint moved(const MapPoint& p) const {
    return {p.x_m + plan_.ground.shift_m.x_m, p.y_m + plan_.ground.shift_m.y_m};
  }
  [[nodiscard]] std::vector<MapPoint> moved(std::vector<MapPoint> points) const {
    for (MapPoint& p : points) p = moved(p);
    return points;
  }

  static PlanDoor door(std::string name, const MapSegment& jambs) {
    return {std::move(name), jambs.from, jambs.to, length_m(jambs)};
  }

  /// Its jambs stand across the way through, half a width to either side of its middle.
  static PlanDoor gap(const MapShape& shape) {
    const MapPoint& a = shape.points.at(0);
    const MapPoint& b = shape.points.at(1);
    const double width = shape.size_m.value_or(kGapWidth_m);
    const MapPoint middle{(a.x_m + b.x_m) / 2.0, (a.y_m + b.y_m) / 2.0};
    const double length = length_m({a, b});
    const double half = length > 0.0 ? width / 2.0 / length : 0.0;
    const double dx = half * (a.y_m - b.y_m);
    const double dy = half * (b.x_m - a.x_m);
    return {
        shape.name, {middle.x_m - dx, middle.y_m - dy}, {middle.x_m + dx, middle.y_m + dy}, width};
  }

  MapPlan plan_;
};

bool on_side(const MapSegment& side, const MapPoint& p) {
  constexpr double kOnRim_m = 1e-9;
  const double around = length_m({side.from, p}) + length_m({p, side.to});
  return around - length_m(side) <= kOnRim_m;
}

/// Whether it lies in the upright rectangle around the outline, or hardly outside.
bool near_outline(const std::vector<MapPoint>& outline, const MapPoint& p) {
  constexpr double kNear_m = 0.01;
  MapPoint low = outline.front();
  MapPoint high = low;
  for (const MapPoint& corner : outline) {
    low = {std::min(low.x_m, corner.x_m), std::min(low.y_m, corner.y_m)};
    high = {std::max(high.x_m, corner.x_m), std::max(high.y_m, corner.y_m)};
  }
  return p.x_m >= low.x_m - kNear_m && p.x_m <= high.x_m + kNear_m && p.y_m >= low.y_m - kNear_m &&
         p.y_m <= high.y_m + kNear_m;
}

}  // namespace

MapPlan plan_of(const OverlayMap& map, Doors doors) {
  Planner planner(ground_of(map, doors));
  for (const MapStatement& statement : map.statements) {
    std::visit([&planner](const auto& content) { planner(content); }, statement.content);
  }
  return planner.take();
}

bool holds_point(const std::vector<MapPoint>& outline, const MapPoint& p) {
  if (outline.empty() || !near_outline(outline, p)) return false;
  bool inside = false;
  for (const MapSegment& side : sides(outline, Outline::Closed)) {
    if (on_side(side, p)) return true;
    if ((side.from.y_m > p.y_m) != (side.to.y_m > p.y_m)) {
      const double share = (p.y_m - side.from.y_m) / (side.to.y_m - side.from.y_m);
      inside ^= p.x_m < side.from.x_m + share * (side.to.x_m - side.from.x_m);
    }
  }
  return inside;
}

std::optional<std::size_t> room_at(const std::vector<PlanRoom>& rooms, const MapPoint& p) {
  const auto found = std::find_if(rooms.begin(), rooms.end(), [&p](const PlanRoom& room) {
    return holds_point(room.outline, p);
  });
  return found == rooms.end() ? std::nullopt
                              : std::optional(static_cast<std::size_t>(found - rooms.begin()));
}

}  // namespace tacit
