#include "console/debrief/open_rooms.h"

#include <algorithm>
#include <iterator>

#include "idl/overlay/openings.h"

namespace tacit {
namespace {

/// Half the length of the way through a gap.
constexpr double kGapReach_m = 0.5;

MapPoint middle(const MapPoint& a, const MapPoint& b) {
  return {(a.x_m + b.x_m) / 2.0, (a.y_m + b.y_m) / 2.0};
}

MapOpening as_opening(const PlanDoor& door) {
  return {MapOpening::Kind::Door, {door.from, door.to}, 0.0};
}

/// The way through stands across the line from jamb to jamb.
MapOpening as_passage(const PlanDoor& gap) {
  const MapPoint at = middle(gap.from, gap.to);
  const double length = length_m({gap.from, gap.to});
  const double share = length > 0.0 ? kGapReach_m / length : 0.0;
  const double dx = share * (gap.from.y_m - gap.to.y_m);
  const double dy = share * (gap.to.x_m - gap.from.x_m);
  return {
      MapOpening::Kind::Gap, {{at.x_m - dx, at.y_m - dy}, {at.x_m + dx, at.y_m + dy}}, gap.width_m};
}

std::vector<MapOpening> openings_of(const MapPlan& plan, Doors doors) {
  std::vector<MapOpening> openings;
  if (doors == Doors::Open) {
    std::transform(plan.doors.begin(), plan.doors.end(), std::back_inserter(openings), as_opening);
  }
  std::transform(plan.gaps.begin(), plan.gaps.end(), std::back_inserter(openings), as_passage);
  return openings;
}

/// Most openings are far from most rooms, and most rooms from most points.
class Box {
 public:
  explicit Box(const std::vector<MapPoint>& outline) {
    for (const MapPoint& p : outline) {
      low_ = {std::min(low_.x_m, p.x_m), std::min(low_.y_m, p.y_m)};
      high_ = {std::max(high_.x_m, p.x_m), std::max(high_.y_m, p.y_m)};
    }
  }
  [[nodiscard]] bool holds(const MapPoint& p, double around_m) const {
    return p.x_m >= low_.x_m - around_m && p.x_m <= high_.x_m + around_m &&
           p.y_m >= low_.y_m - around_m && p.y_m <= high_.y_m + around_m;
  }

 private:
  MapPoint low_{1e300, 1e300};
  MapPoint high_{-1e300, -1e300};
};

bool is_open(const PlanRoom& room, const std::vector<MapOpening>& openings) {
  const Box box(room.outline);
  const std::vector<MapSegment> walls = sides(room.outline, Outline::Closed);
  return std::any_of(openings.begin(), openings.end(), [&](const MapOpening& opening) {
    const MapPoint at = middle(opening.place.from, opening.place.to);
    const double reach_m = length_m(opening.place) + opening.width_m + kDoorReach_m;
    return box.holds(at, reach_m) &&
           std::any_of(walls.begin(), walls.end(), [&opening](const MapSegment& wall) {
             return opened(wall, opening).has_value();
           });
  });
}

}  // namespace

std::vector<bool> open_rooms(const MapPlan& plan, Doors doors) {
  const std::vector<MapOpening> openings = openings_of(plan, doors);
  std::vector<bool> open;
  open.reserve(plan.rooms.size());
  for (const PlanRoom& room : plan.rooms) {
    open.push_back(is_open(room, openings));
  }
  return open;
}

std::vector<std::uint32_t> rooms_at(const MapPlan& plan, const std::vector<MapPoint>& points) {
  constexpr double kRim_m = 1e-6;
  std::vector<std::uint32_t> numbers(points.size(), 0);
  for (std::size_t room = plan.rooms.size(); room-- > 0;) {
    const std::vector<MapPoint>& outline = plan.rooms[room].outline;
    const Box box(outline);
    for (std::size_t i = 0; i < points.size(); ++i) {
      if (box.holds(points[i], kRim_m) && holds_point(outline, points[i])) {
        numbers[i] = static_cast<std::uint32_t>(room + 1);
      }
    }
  }
  return numbers;
}

}  // namespace tacit
