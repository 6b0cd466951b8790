#include "deploy/lockstep/start_places.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "world_server/world/terrain.h"

namespace tacit {
namespace {

/// A robot's radius and a hand's breadth.
constexpr double kClearanceM = 0.35;
constexpr double kApartM = 0.8;
constexpr double kSearchM = 20.0;

WorldVec vec(const MapPoint& p) { return {p.x_m, p.y_m}; }

double distance_m(const WorldVec& p, const MapSegment& wall) {
  return (p - nearest_point({vec(wall.from), vec(wall.to)}, p)).norm();
}

/// Whether two segments cross.
bool cross(const WorldVec& a, const WorldVec& b, const MapSegment& wall) {
  const WorldVec c = vec(wall.from);
  const WorldVec d = vec(wall.to);
  const double side_c = (b - a).cross(c - a);
  const double side_d = (b - a).cross(d - a);
  const double side_a = (d - c).cross(a - c);
  const double side_b = (d - c).cross(b - c);
  return side_c * side_d <= 0.0 && side_a * side_b <= 0.0 && (b - a).squared_norm() > 0.0;
}

/// The longer way along the centre line from where it comes nearest to `place`.
Heading longer_way(const MapHallway& hall, const WorldVec& place) {
  const WorldVec first = vec(hall.centre_line.front());
  const WorldVec last = vec(hall.centre_line.back());
  const WorldVec end = (first - place).norm() > (last - place).norm() ? first : last;
  // The segment that the robot is beside gives the direction, the farther end its sense.
  WorldVec along = end - place;
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i + 1 < hall.centre_line.size(); ++i) {
    const MapSegment part{hall.centre_line[i], hall.centre_line[i + 1]};
    const double away = distance_m(place, part);
    if (away >= nearest) continue;
    nearest = away;
    along = vec(part.to) - vec(part.from);
  }
  if (along.dot(end - place) < 0.0) along = -along;
  along = unit(along);
  return along.squared_norm() > 0.0 ? Heading{along.x(), along.y()} : Heading{};
}

}  // namespace

WorldVec StartPlaces::team_m() const {
  const MapGround& ground = plan_->ground;
  return ground.start ? vec(*ground.start)
                      : WorldVec{0.5 * ground.size.width_m, 0.5 * ground.size.height_m};
}

Heading StartPlaces::facing(const WorldVec& place_m, const std::optional<WorldVec>& goal_m) const {
  const MapPoint at{place_m.x(), place_m.y()};
  WorldVec towards{0.5 * plan_->ground.size.width_m, 0.5 * plan_->ground.size.height_m};
  if (goal_m) {
    towards = *goal_m;
  } else {
    for (const MapHallway& hall : plan_->halls) {
      if (hall.centre_line.size() > 1 && holds_point(hall.outline, at)) {
        return longer_way(hall, place_m);
      }
    }
  }
  const WorldVec way = unit(towards - place_m);
  return way.squared_norm() > 0.0 ? Heading{way.x(), way.y()} : Heading{};
}

std::optional<WorldVec> StartPlaces::take(const WorldVec& wanted_m) {
  constexpr double kStepM = 0.25;
  const int rings = static_cast<int>(kSearchM / kStepM);
  for (int ring = 0; ring <= rings; ++ring) {
    std::optional<WorldVec> best;
    for (int i = -ring; i <= ring; ++i) {
      const int step = std::abs(i) == ring ? 1 : std::max(1, 2 * ring);
      for (int j = -ring; j <= ring; j += step) {
        const WorldVec place_m = wanted_m + WorldVec{kStepM * i, kStepM * j};
        const bool nearer =
            !best || (place_m - wanted_m).squared_norm() < (*best - wanted_m).squared_norm();
        if (nearer && free(place_m) && in_sight(wanted_m, place_m)) best = place_m;
      }
    }
    if (!best) continue;
    taken_m_.push_back(*best);
    return best;
  }
  return std::nullopt;
}

bool StartPlaces::free(const WorldVec& place_m) const {
  const MapGround& ground = plan_->ground;
  const bool inside = place_m.x() >= kClearanceM && place_m.y() >= kClearanceM &&
                      place_m.x() <= ground.size.width_m - kClearanceM &&
                      place_m.y() <= ground.size.height_m - kClearanceM;
  return inside &&
         std::none_of(taken_m_.begin(), taken_m_.end(),
                      [&](const WorldVec& other) { return (other - place_m).norm() < kApartM; }) &&
         std::none_of(
             ground.discs.begin(), ground.discs.end(),
             [&](const std::vector<double>& disc) {
               return (WorldVec{disc[0], disc[1]} - place_m).norm() < disc[2] + kClearanceM;
             }) &&
         std::none_of(ground.walls.begin(), ground.walls.end(), [&](const MapSegment& wall) {
           return distance_m(place_m, wall) < kClearanceM;
         });
}

bool StartPlaces::in_sight(const WorldVec& from_m, const WorldVec& to_m) const {
  const auto& walls = plan_->ground.walls;
  return std::none_of(walls.begin(), walls.end(),
                      [&](const MapSegment& wall) { return cross(from_m, to_m, wall); });
}

}  // namespace tacit
