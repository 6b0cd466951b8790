#include "idl/overlay/check.h"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "idl/overlay/ground.h"
#include "idl/overlay/reader.h"
#include "idl/overlay/statement.h"

namespace tacit {
namespace {

constexpr double kLittle = 1e-6;
/// Pairs of doors and sides; more are not looked through.
constexpr std::size_t kMostCompared = 20'000'000;

double area_m2(const std::vector<MapPoint>& points) {
  double twice = 0.0;
  for (const MapSegment& side : sides(points, Outline::Closed)) {
    twice += side.from.x_m * side.to.y_m - side.to.x_m * side.from.y_m;
  }
  return twice < 0.0 ? -twice / 2.0 : twice / 2.0;
}

std::string spelled(double value) {
  std::string text = std::to_string(value);
  text.erase(text.find_last_not_of('0') + 1);
  return text.ends_with('.') ? text.substr(0, text.size() - 1) : text;
}

std::string in_quotes(const std::string& name) { return '"' + name + '"'; }

class Checker {
 public:
  explicit Checker(const OverlayMap& map) : map_(map), area_(mission_area(map)) {}

  MapFindings findings() {
    for (const MapStatement& statement : map_.statements) {
      at_ = statement.at;
      std::visit([this](const auto& content) { look_at(content); }, statement.content);
    }
    check_doors();
    std::stable_sort(findings_.begin(), findings_.end(), [](const auto& a, const auto& b) {
      return std::pair(a.at.line, a.at.column) < std::pair(b.at.line, b.at.column);
    });
    return std::move(findings_);
  }

 private:
  void note(Severity severity, const std::string& text) {
    std::size_t& told = severity == Severity::Error ? errors_ : warnings_;
    if (++told <= kMostFindings / 2) {
      findings_.push_back({severity, at_, text});
    }
  }
  void error_if(bool wrong, const std::string& text) {
    if (wrong) note(Severity::Error, text);
  }
  void warn_if(bool odd, const std::string& text) {
    if (odd) note(Severity::Warning, text);
  }

  void look_at(const MapUnknown& /*unknown*/) {}
  void look_at(const MapMeasures& /*measures*/) { in_measures_ = true; }

  void look_at(const MapHeader& header) {
    if (header.kind != HeaderKind::MissionArea) return;
    warn_if(seen_area_, "found a second MISSION-AREA, wanted one; the first counts");
    seen_area_ = true;
    error_if(header.numbers[0] <= 0.0 || header.numbers[1] <= 0.0,
             "found a MISSION-AREA of " + spelled(header.numbers[0]) + " by " +
                 spelled(header.numbers[1]) + ", wanted both above 0");
  }

  void look_at(const MapObstacle& obstacle) {
    note_measure();
    look_at_disc("an OBSTACLE", obstacle.centre, obstacle.radius_m);
  }

  void look_at(const MapObject& object) {
    note_measure();
    look_at_disc("an OBJECT", object.centre, object.radius_m);
  }

  void look_at_disc(const std::string& what, const MapPoint& centre, double radius_m) {
    error_if(radius_m <= 0.0,
             "found " + what + " of radius " + spelled(radius_m) + ", wanted it above 0");
    look_whether_outside(what, {centre});
  }

  void look_at(const MapHallway& hallway) {
    note_measure();
    error_if(hallway.width_m <= 0.0, "found HALLWAY " + in_quotes(hallway.name) + " of width " +
                                         spelled(hallway.width_m) + ", wanted it above 0");
    error_if(area_m2(hallway.outline) < kLittle,
             "found HALLWAY " + in_quotes(hallway.name) +
                 " whose outline encloses nothing, wanted an area");
    look_whether_outside("HALLWAY " + in_quotes(hallway.name), hallway.outline);
    outlines_.push_back(
        {at_, hallway.name, sides(hallway.outline, Outline::Closed), Part::Hallway});
  }

  void look_at(const MapShape& shape) {
    note_measure();
    const std::string what = std::string(form_of(shape.kind).keyword) + ' ' + in_quotes(shape.name);
    look_at_name(shape, what);
    look_whether_outside(what, shape.points);
    switch (shape.kind) {
      case ShapeKind::Room:
        error_if(area_m2(shape.points) < kLittle,
                 "found " + what + " whose outline encloses nothing, wanted an area");
        outlines_.push_back({at_, shape.name, sides(shape.points, Outline::Closed), Part::Room});
        break;
      case ShapeKind::Wall:
      case ShapeKind::Boundary:
        look_at_line(what, shape);
        outlines_.push_back({at_, what, sides(shape.points, Outline::Open), Part::Wall});
        break;
      case ShapeKind::Door:
      case ShapeKind::Gap:
        warn_if(shape.points[0] == shape.points[1],
                "found " + what + " without length, wanted two places");
        openings_.push_back({at_, what, *opening_of(shape)});
        break;
      default:
        look_at_point(what, shape);
    }
  }

  void look_at_line(const std::string& what, const MapShape& shape) {
    const bool dot = std::all_of(shape.points.begin(), shape.points.end(),
                                 [&](const MapPoint& p) { return p == shape.points.front(); });
    warn_if(dot, "found " + what + " without length, wanted at least two places");
  }

  void look_at_point(const std::string& what, const MapShape& shape) {
    error_if(shape.points.size() == 1 && shape.size_m && *shape.size_m < 0.0,
             "found " + what + " of radius " + spelled(shape.size_m.value_or(0.0)) +
                 ", wanted it not below 0");
    if (shape.kind == ShapeKind::StartPoint ||
        (shape.kind == ShapeKind::PassagePoint && is_start_place(shape.name))) {
      warn_if(seen_start_, "found a second start place, " + what + "; the first counts");
      seen_start_ = true;
    }
  }

  void look_at_name(const MapShape& shape, const std::string& what) {
    if (!shape.name.empty() && !is_start_place(shape.name)) {
      const auto [known, is_new] = names_.try_emplace({shape.kind, shape.name}, at_);
      warn_if(!is_new, "found " + what + " again, wanted another name than in line " +
                           std::to_string(known->second.line));
    }
  }

  void note_measure() {
    warn_if(!in_measures_ && !told_order_,
            "found a measure before the line CONTROL MEASURES:, wanted it behind");
    told_order_ = told_order_ || !in_measures_;
  }

  void look_whether_outside(const std::string& what, const std::vector<MapPoint>& points) {
    if (!area_) return;
    const bool outside = std::any_of(points.begin(), points.end(), [this](const MapPoint& p) {
      return p.x_m < 0.0 || p.y_m < 0.0 || p.x_m > area_->width_m || p.y_m > area_->height_m;
    });
    warn_if(outside, "found " + what + " reaching outside the MISSION-AREA of " +
                         spelled(area_->width_m) + " by " + spelled(area_->height_m) +
                         ", wanted it inside; what lies outside is not built");
  }

  enum class Part : std::uint8_t { Room, Hallway, Wall };
  struct PlacedOutline {
    MapSpot at;
    std::string name;
    std::vector<MapSegment> sides;
    Part part = Part::Wall;
    bool has_opening = false;
  };
  struct PlacedOpening {
    MapSpot at;
    std::string what;
    MapOpening opening;
  };

  static bool lies_in(const MapOpening& opening, const PlacedOutline& outline) {
    return std::any_of(
        outline.sides.begin(), outline.sides.end(),
        [&opening](const MapSegment& side) { return opened(side, opening).has_value(); });
  }

  void check_doors() {
    std::size_t all_sides = 1;
    for (const PlacedOutline& outline : outlines_) all_sides += outline.sides.size();
    if (openings_.size() > kMostCompared / all_sides) {
      at_ = {};
      note(Severity::Warning, "found too many doors and rooms to compare, wanted fewer");
      return;
    }
    for (const PlacedOpening& door : openings_) check_door(door);
    if (wall_kind(map_) == ShapeKind::Room) check_rooms();
  }

  /// Where the map draws walls of its own, a room may be shut on purpose, or open without a door.
  void check_rooms() {
    for (const PlacedOutline& outline : outlines_) {
      at_ = outline.at;
      warn_if(
          outline.part == Part::Room && !outline.has_opening,
          "found ROOM " + in_quotes(outline.name) + " without a door, wanted a DOOR or GAP in it");
    }
  }

  void check_door(const PlacedOpening& door) {
    bool placed = false;
    for (PlacedOutline& outline : outlines_) {
      if (lies_in(door.opening, outline)) {
        placed = outline.has_opening = true;
        look_whether_shut(outline, door);
      }
    }
    at_ = door.at;
    warn_if(!placed && door.opening.kind == MapOpening::Kind::Door,
            "found " + door.what +
                " in no wall, wanted both its ends in the line of a wall, a room's side or a "
                "hallway's side");
  }

  void look_whether_shut(const PlacedOutline& outline, const PlacedOpening& door) {
    if (outline.part != Part::Wall || outline.sides.size() != 1) return;
    const auto stretch = opened(outline.sides.front(), door.opening);
    at_ = outline.at;
    warn_if(stretch && takes_all(outline.sides.front(), *stretch),
            "found " + outline.name + " whole in " + door.what +
                ", which opens it; wanted the opening gone if this wall is to shut it");
  }

  const OverlayMap& map_;
  std::optional<MapSize> area_;
  MapFindings findings_;
  MapSpot at_;
  std::size_t errors_ = 0;
  std::size_t warnings_ = 0;
  bool in_measures_ = false;
  bool told_order_ = false;
  bool seen_area_ = false;
  bool seen_start_ = false;
  std::map<std::pair<ShapeKind, std::string>, MapSpot> names_;
  std::vector<PlacedOutline> outlines_;
  std::vector<PlacedOpening> openings_;
};

}  // namespace

MapFindings check(const OverlayMap& map) { return Checker(map).findings(); }

}  // namespace tacit
