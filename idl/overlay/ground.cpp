#include "idl/overlay/ground.h"

#include <algorithm>
#include <array>
#include <limits>
#include <set>
#include <string>

#include "idl/overlay/tokens.h"
#include "idl/types/config_error.h"

namespace tacit {
namespace {

constexpr double kMargin_m = 1.0;
constexpr double kShortest_m = 1e-6;

template <class Content>
std::vector<const Content*> all(const OverlayMap& map) {
  std::vector<const Content*> found;
  for (const MapStatement& statement : map.statements) {
    if (const auto* content = std::get_if<Content>(&statement.content)) {
      found.push_back(content);
    }
  }
  return found;
}

bool holds(const OverlayMap& map, ShapeKind kind) {
  const auto shapes = all<MapShape>(map);
  return std::any_of(shapes.begin(), shapes.end(),
                     [kind](const MapShape* shape) { return shape->kind == kind; });
}

std::vector<MapOpening> openings(const OverlayMap& map, Doors doors) {
  std::vector<MapOpening> found;
  for (const MapShape* shape : all<MapShape>(map)) {
    const auto opening = opening_of(*shape);
    if (opening && (opening->kind == MapOpening::Kind::Gap || doors == Doors::Open)) {
      found.push_back(*opening);
    }
  }
  return found;
}

/// Of all shapes of one kind.
std::size_t corners(const OverlayMap& map, ShapeKind kind) {
  std::size_t count = 0;
  for (const MapShape* shape : all<MapShape>(map)) {
    count += shape->kind == kind ? shape->points.size() : 0;
  }
  return count;
}

void require_few(std::size_t pairs, const std::string& what) {
  if (pairs > kMostPairs) {
    throw ConfigError("found a map with too many pairs of " + what +
                      " to compare, wanted at most " + std::to_string(kMostPairs));
  }
}

void add_wall(const MapSegment& wall, const std::vector<MapOpening>& openings,
              std::vector<MapSegment>& walls) {
  std::vector<MapStretch> stretches;
  for (const MapOpening& opening : openings) {
    if (const auto stretch = opened(wall, opening)) {
      stretches.push_back(*stretch);
    }
  }
  for (const MapSegment& left : without(wall, std::move(stretches))) {
    if (length_m(left) > kShortest_m) {
      walls.push_back(left);
    }
  }
}

class Box {
 public:
  void take(const std::vector<MapPoint>& points) {
    for (const MapPoint& p : points) take(p, 0.0);
  }
  void take(const MapPoint& p, double radius_m) {
    low_ = {std::min(low_.x_m, p.x_m - radius_m), std::min(low_.y_m, p.y_m - radius_m)};
    high_ = {std::max(high_.x_m, p.x_m + radius_m), std::max(high_.y_m, p.y_m + radius_m)};
  }
  [[nodiscard]] bool empty() const { return low_.x_m > high_.x_m; }
  [[nodiscard]] MapExtent extent() const { return {low_, high_}; }
  [[nodiscard]] MapPoint shift() const {
    return empty() ? MapPoint{} : MapPoint{kMargin_m - low_.x_m, kMargin_m - low_.y_m};
  }
  [[nodiscard]] MapSize size() const {
    return empty() ? MapSize{2.0 * kMargin_m, 2.0 * kMargin_m}
                   : MapSize{high_.x_m - low_.x_m + 2.0 * kMargin_m,
                             high_.y_m - low_.y_m + 2.0 * kMargin_m};
  }

 private:
  static constexpr double kFar = std::numeric_limits<double>::infinity();
  MapPoint low_{kFar, kFar};
  MapPoint high_{-kFar, -kFar};
};

Box box_of(const OverlayMap& map) {
  Box box;
  for (const MapShape* shape : all<MapShape>(map)) box.take(shape->points);
  for (const MapHallway* hallway : all<MapHallway>(map)) box.take(hallway->outline);
  for (const MapObstacle* one : all<MapObstacle>(map)) box.take(one->centre, one->radius_m);
  for (const MapObject* one : all<MapObject>(map)) box.take(one->centre, one->radius_m);
  return box;
}

MapPoint shifted(const MapPoint& p, const MapPoint& shift) {
  return {p.x_m + shift.x_m, p.y_m + shift.y_m};
}

bool inside(const MapPoint& p, const MapSize& size) {
  return p.x_m >= 0.0 && p.y_m >= 0.0 && p.x_m <= size.width_m && p.y_m <= size.height_m;
}

/// Narrows [first, last], shares of a wall, to where `from + share * step` lies in [0, most].
void narrow(double from, double step, double most, std::array<double, 2>& shares) {
  if (step == 0.0) {
    if (from < 0.0 || from > most) shares[1] = -1.0;
    return;
  }
  const double a = (0.0 - from) / step;
  const double b = (most - from) / step;
  shares[0] = std::max(shares[0], std::min(a, b));
  shares[1] = std::min(shares[1], std::max(a, b));
}

/// The part of `wall` in the area (Liang & Barsky 1984).
std::optional<MapSegment> cut_off(const MapSegment& wall, const MapSize& size) {
  if (inside(wall.from, size) && inside(wall.to, size)) return wall;
  const double dx = wall.to.x_m - wall.from.x_m;
  const double dy = wall.to.y_m - wall.from.y_m;
  std::array<double, 2> shares{0.0, 1.0};
  narrow(wall.from.x_m, dx, size.width_m, shares);
  narrow(wall.from.y_m, dy, size.height_m, shares);
  if (shares[0] >= shares[1]) return std::nullopt;
  const auto place = [&](double share) {
    return MapPoint{std::clamp(wall.from.x_m + share * dx, 0.0, size.width_m),
                    std::clamp(wall.from.y_m + share * dy, 0.0, size.height_m)};
  };
  return MapSegment{place(shares[0]), place(shares[1])};
}

bool is_solid(const MapObject& object) {
  const std::string colour = capitals(object.colour);
  return object.mobility == Mobility::Fixed && (colour == "BLACK" || colour == "DARKSEAGREEN");
}

bool is_mine(const MapObject& object) {
  return object.mobility == Mobility::Movable && capitals(object.colour) == "ORANGE";
}

/// A tree is at times written down twice, as obstacle and as object.
void add_discs(const OverlayMap& map, MapGround& ground) {
  std::set<std::vector<double>> known;
  const auto add = [&](const MapPoint& centre, double radius_m) {
    const MapPoint at = shifted(centre, ground.shift_m);
    std::vector<double> row{at.x_m, at.y_m, radius_m};
    if (radius_m > 0.0 && inside(at, ground.size) && known.insert(row).second) {
      ground.discs.push_back(std::move(row));
    }
  };
  for (const MapObstacle* one : all<MapObstacle>(map)) add(one->centre, one->radius_m);
  for (const MapObject* one : all<MapObject>(map)) {
    if (is_solid(*one)) add(one->centre, one->radius_m);
  }
}

bool in_a_disc(const MapPoint& p, const std::vector<std::vector<double>>& discs) {
  return std::any_of(discs.begin(), discs.end(), [&p](const std::vector<double>& row) {
    return length_m({p, {row[0], row[1]}}) < row[2];
  });
}

void add_mines(const OverlayMap& map, MapGround& ground) {
  std::set<std::vector<double>> known;
  const std::vector<const MapObject*> objects = all<MapObject>(map);
  require_few(objects.size() * ground.discs.size(), "objects and obstacles");
  for (const MapObject* one : objects) {
    const MapPoint at = shifted(one->centre, ground.shift_m);
    std::vector<double> row{at.x_m, at.y_m};
    if (is_mine(*one) && inside(at, ground.size) && !in_a_disc(at, ground.discs) &&
        known.insert(row).second) {
      ground.mines.push_back(std::move(row));
    }
  }
}

void add_walls(const OverlayMap& map, Doors doors, MapGround& ground) {
  for (const MapSegment& wall : walls_of(map, doors)) {
    const auto part = cut_off(
        {shifted(wall.from, ground.shift_m), shifted(wall.to, ground.shift_m)}, ground.size);
    if (part && length_m(*part) > kShortest_m) {
      ground.walls.push_back(*part);
    }
  }
}

}  // namespace

MapExtent extent_of(const OverlayMap& map) {
  Box box = box_of(map);
  const std::optional<MapSize> area = mission_area(map);
  if (area || box.empty()) {
    const MapSize size = area.value_or(box.size());
    box.take({MapPoint{}, {size.width_m, size.height_m}});
  }
  return box.extent();
}

ShapeKind wall_kind(const OverlayMap& map) {
  if (holds(map, ShapeKind::Wall)) return ShapeKind::Wall;
  return holds(map, ShapeKind::Room) ? ShapeKind::Room : ShapeKind::Boundary;
}

std::vector<MapSegment> walls_of(const OverlayMap& map, Doors doors) {
  const ShapeKind kind = wall_kind(map);
  const std::vector<MapOpening> open = openings(map, doors);
  require_few(open.size() * corners(map, kind), "walls and doors");
  std::vector<MapSegment> walls;
  for (const MapShape* shape : all<MapShape>(map)) {
    if (shape->kind == kind) {
      const Outline outline = kind == ShapeKind::Room ? Outline::Closed : Outline::Open;
      for (const MapSegment& side : sides(shape->points, outline)) {
        add_wall(side, open, walls);
      }
    } else if (shape->kind == ShapeKind::Door && doors == Doors::Closed) {
      walls.push_back({shape->points.at(0), shape->points.at(1)});
    }
  }
  return walls;
}

MapGround ground_of(const OverlayMap& map, Doors doors) {
  MapGround ground;
  if (const auto area = mission_area(map)) {
    ground.size = *area;
  } else {
    const Box box = box_of(map);
    ground.size = box.size();
    ground.shift_m = box.shift();
  }
  add_walls(map, doors, ground);
  add_discs(map, ground);
  add_mines(map, ground);
  if (const auto start = start_place(map)) {
    const MapPoint at = shifted(*start, ground.shift_m);
    ground.start = inside(at, ground.size) ? std::optional(at) : std::nullopt;
  }
  return ground;
}

}  // namespace tacit
