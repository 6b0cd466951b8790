#include "idl/overlay/openings.h"

#include <algorithm>
#include <cmath>

namespace tacit {
namespace {

constexpr double kTiny_m = 1e-6;

/// A point as a wall sees it.
struct Along {
  double along_m;
  double aside_m;
};

Along seen_from(const MapSegment& wall, double length, const MapPoint& p) {
  const double ux = (wall.to.x_m - wall.from.x_m) / length;
  const double uy = (wall.to.y_m - wall.from.y_m) / length;
  const double dx = p.x_m - wall.from.x_m;
  const double dy = p.y_m - wall.from.y_m;
  return {dx * ux + dy * uy, ux * dy - uy * dx};
}

MapStretch door_stretch(const Along& a, const Along& b) {
  const bool lies_in = std::abs(a.aside_m) <= kDoorReach_m && std::abs(b.aside_m) <= kDoorReach_m;
  return lies_in ? MapStretch{std::min(a.along_m, b.along_m), std::max(a.along_m, b.along_m)}
                 : MapStretch{};
}

MapStretch gap_stretch(const Along& a, const Along& b, double width_m) {
  const double across = a.aside_m - b.aside_m;
  if (a.aside_m * b.aside_m > 0.0 || std::abs(across) < kTiny_m) {
    return {};
  }
  const double middle = a.along_m + (b.along_m - a.along_m) * a.aside_m / across;
  return {middle - width_m / 2.0, middle + width_m / 2.0};
}

MapPoint at(const MapSegment& wall, double share) {
  return {wall.from.x_m + share * (wall.to.x_m - wall.from.x_m),
          wall.from.y_m + share * (wall.to.y_m - wall.from.y_m)};
}

}  // namespace

double length_m(const MapSegment& segment) {
  const double dx = segment.to.x_m - segment.from.x_m;
  const double dy = segment.to.y_m - segment.from.y_m;
  return std::sqrt(dx * dx + dy * dy);
}

std::optional<MapOpening> opening_of(const MapShape& shape) {
  if (shape.points.size() < 2) return std::nullopt;
  const MapSegment place{shape.points[0], shape.points[1]};
  if (shape.kind == ShapeKind::Door) return MapOpening{MapOpening::Kind::Door, place, 0.0};
  if (shape.kind != ShapeKind::Gap) return std::nullopt;
  return MapOpening{MapOpening::Kind::Gap, place, shape.size_m.value_or(kGapWidth_m)};
}

std::optional<MapStretch> opened(const MapSegment& wall, const MapOpening& opening) {
  const double length = length_m(wall);
  if (length < kTiny_m) return std::nullopt;
  const Along a = seen_from(wall, length, opening.place.from);
  const Along b = seen_from(wall, length, opening.place.to);
  const MapStretch stretch = opening.kind == MapOpening::Kind::Door
                                 ? door_stretch(a, b)
                                 : gap_stretch(a, b, opening.width_m);
  const double shared = std::min(stretch.to_m, length) - std::max(stretch.from_m, 0.0);
  return shared > kTiny_m ? std::optional(stretch) : std::nullopt;
}

bool takes_all(const MapSegment& wall, const MapStretch& stretch) {
  return stretch.from_m <= kTiny_m && stretch.to_m >= length_m(wall) - kTiny_m;
}

std::vector<MapSegment> without(const MapSegment& wall, std::vector<MapStretch> stretches) {
  const double length = length_m(wall);
  if (stretches.empty()) return {wall};
  std::sort(stretches.begin(), stretches.end(),
            [](const MapStretch& a, const MapStretch& b) { return a.from_m < b.from_m; });
  std::vector<MapSegment> left;
  double reached_m = 0.0;
  const auto keep_up_to = [&](double end_m, const MapPoint& end) {
    if (end_m - reached_m > kTiny_m) {
      left.push_back({reached_m == 0.0 ? wall.from : at(wall, reached_m / length), end});
    }
  };
  for (const MapStretch& stretch : stretches) {
    keep_up_to(stretch.from_m, at(wall, stretch.from_m / length));
    reached_m = std::max(reached_m, stretch.to_m);
  }
  keep_up_to(length, wall.to);
  return left;
}

std::vector<MapSegment> sides(const std::vector<MapPoint>& points, Outline outline) {
  std::vector<MapSegment> all;
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    all.push_back({points[i], points[i + 1]});
  }
  if (outline == Outline::Closed && points.size() > 2) {
    all.push_back({points.back(), points.front()});
  }
  return all;
}

}  // namespace tacit
