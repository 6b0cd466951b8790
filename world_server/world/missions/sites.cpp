#include "world_server/world/missions/sites.h"

#include <algorithm>
#include <limits>

#include "world_server/world/missions/operation_map.h"
#include "world_server/world/terrain.h"

namespace tacit {
namespace {

/// Where on a centre line somebody is.
struct OnLine {
  WorldVec nearest_m;
  WorldVec along;
  double from_start_m = 0.0;
  double length_m = 0.0;  ///< Of the whole line.
};

/// The place on `line` nearest to `p`, the first of equally near ones.
OnLine on_line(const std::vector<MapPoint>& line, const WorldVec& p) {
  OnLine found;
  double nearest2 = std::numeric_limits<double>::infinity();
  for (std::size_t i = 1; i < line.size(); ++i) {
    const Wall part{place_of(line[i - 1]), place_of(line[i])};
    const double length_m = (part.to_m - part.from_m).norm();
    const WorldVec nearest = nearest_point(part, p);
    const double range2 = (nearest - p).squared_norm();
    if (length_m > 0.0 && range2 < nearest2) {
      nearest2 = range2;
      found.nearest_m = nearest;
      found.along = unit(part.to_m - part.from_m);
      found.from_start_m = found.length_m + (nearest - part.from_m).norm();
    }
    found.length_m += length_m;
  }
  return found;
}

}  // namespace

Sites::Sites(const MapPlan& plan) : rooms_(plan.rooms), halls_(plan.halls) {
  for (const PlanRoom& room : rooms_) {
    room_boxes_.push_back(box_of(room.outline));
  }
  for (const MapHallway& hall : halls_) {
    hall_boxes_.push_back(box_of(hall.outline));
  }
}

Sites::Box Sites::box_of(const std::vector<MapPoint>& outline) {
  constexpr double kFar = std::numeric_limits<double>::infinity();
  constexpr double kRim_m = 1e-6;
  Box box{{kFar, kFar}, {-kFar, -kFar}};
  for (const MapPoint& p : outline) {
    box.low = {std::min(box.low.x(), p.x_m - kRim_m), std::min(box.low.y(), p.y_m - kRim_m)};
    box.high = {std::max(box.high.x(), p.x_m + kRim_m), std::max(box.high.y(), p.y_m + kRim_m)};
  }
  return box;
}

bool Sites::holds(const Box& box, const std::vector<MapPoint>& outline, const WorldVec& p) {
  return p.x() >= box.low.x() && p.x() <= box.high.x() && p.y() >= box.low.y() &&
         p.y() <= box.high.y() && holds_point(outline, {p.x(), p.y()});
}

Spot Sites::at(const WorldVec& p) const {
  for (std::size_t i = 0; i < rooms_.size(); ++i) {
    if (holds(room_boxes_[i], rooms_[i].outline, p)) {
      return {Site::Room, static_cast<std::uint32_t>(i + 1)};
    }
  }
  for (std::size_t i = 0; i < halls_.size(); ++i) {
    if (holds(hall_boxes_[i], halls_[i].outline, p)) {
      return {Site::Hallway, static_cast<std::uint32_t>(i + 1)};
    }
  }
  return {};
}

std::optional<SeenHallway> Sites::hallway(std::uint32_t number, const WorldPose& eye) const {
  const MapHallway& hall = halls_.at(number - 1);
  const OnLine here = on_line(hall.centre_line, eye.position_m);
  if (here.length_m <= 0.0) {
    return std::nullopt;
  }
  return SeenHallway{
      to_body(eye.heading, here.nearest_m - eye.position_m), to_body(eye.heading, here.along),
      std::max(0.0, here.length_m - here.from_start_m), here.from_start_m, hall.width_m};
}

}  // namespace tacit
