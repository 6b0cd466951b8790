#include "deploy/tacit/map_picture.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "console/report/svg.h"
#include "idl/overlay/ground.h"
#include "idl/types/lowered.h"

namespace tacit {
namespace {

constexpr double kLongSide = 1000.0;
constexpr double kEdge = 24.0;
constexpr double kFoot = 44.0;
constexpr double kLetter = 0.58;  ///< Its width, as a share of the size.

constexpr std::string_view kRoom = "fill=\"#f7efdc\" stroke=\"#d8c9a3\"";
constexpr std::string_view kHallway = "fill=\"#e4edf5\" stroke=\"none\"";
constexpr std::string_view kGround = "fill=\"#e9f3e4\" stroke=\"#7fa06f\" stroke-dasharray=\"5 3\"";
constexpr std::string_view kLine = "fill=\"none\" stroke=\"#8f9aa5\"";
constexpr std::string_view kWall = "stroke=\"#26303a\" stroke-width=\"2\" stroke-linecap=\"round\"";
constexpr std::string_view kDoor = "stroke=\"#c0792c\" stroke-width=\"3\" stroke-opacity=\"0.75\"";
constexpr std::string_view kGap = "stroke=\"#2f9e44\" stroke-width=\"1.5\"";
constexpr std::string_view kObstacle = "fill=\"#6c757d\" stroke=\"#343a40\"";

/// A colour's name as SVG knows it; grey for what can be no name.
std::string colour_name(const std::string& spelled) {
  const std::string colour = lowered(spelled);
  const bool letters = std::all_of(colour.begin(), colour.end(),
                                   [](unsigned char c) { return c >= 'a' && c <= 'z'; });
  return letters && !colour.empty() ? colour : "grey";
}

bool is_shown(const std::string& name) { return !name.empty() && !name.ends_with('*'); }

/// Parts of the picture, one above the other.
struct Layers {
  std::string floors;
  std::string lines;
  std::string walls;
  std::string bodies;
  std::string names;
};

class Drawing {
 public:
  explicit Drawing(const OverlayMap& map) : map_(map), extent_(extent_of(map)) {
    const double width_m = extent_.high.x_m - extent_.low.x_m;
    const double height_m = extent_.high.y_m - extent_.low.y_m;
    scale_ = kLongSide / std::max({width_m, height_m, 1e-9});
    width_ = scale_ * width_m + 2.0 * kEdge;
    height_ = scale_ * height_m + kEdge + kFoot;
  }

  std::string text() {
    for (const MapSegment& wall : walls_of(map_, Doors::Open)) {
      layers_.walls += svg_line(at(wall.from), at(wall.to), kWall);
    }
    for (const MapStatement& statement : map_.statements) {
      std::visit([this](const auto& content) { draw(content); }, statement.content);
    }
    name_points();
    return "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" + svg_number(width_) +
           "\" height=\"" + svg_number(height_) + "\" font-family=\"sans-serif\">\n" +
           "<rect width=\"100%\" height=\"100%\" fill=\"#ffffff\"/>\n" + area() + layers_.floors +
           layers_.lines + layers_.walls + layers_.bodies + layers_.names + bar() + "</svg>\n";
  }

 private:
  [[nodiscard]] SvgPlace at(const MapPoint& p) const {
    return {kEdge + scale_ * (p.x_m - extent_.low.x_m),
            kEdge + scale_ * (extent_.high.y_m - p.y_m)};
  }

  [[nodiscard]] std::string points(const char* element, const std::vector<MapPoint>& all,
                                   std::string_view style) const {
    std::vector<SvgPlace> places;
    for (const MapPoint& p : all) places.push_back(at(p));
    return '<' + std::string(element) + " points=\"" + svg_list(places) + "\" " +
           std::string(style) + "/>\n";
  }

  [[nodiscard]] std::string disc(const MapPoint& centre, double radius_m,
                                 std::string_view style) const {
    constexpr double kLeast = 2.0;
    const SvgPlace place = at(centre);
    return "<circle cx=\"" + svg_number(place.x) + "\" cy=\"" + svg_number(place.y) + "\" r=\"" +
           svg_number(std::max(kLeast, scale_ * radius_m)) + "\" " + std::string(style) + "/>\n";
  }

  [[nodiscard]] std::string area() const {
    const auto size = mission_area(map_);
    const MapPoint low = size ? MapPoint{} : extent_.low;
    const MapPoint high = size ? MapPoint{size->width_m, size->height_m} : extent_.high;
    return points("polygon", {low, {high.x_m, low.y_m}, high, {low.x_m, high.y_m}},
                  "fill=\"#fdfdfb\" stroke=\"#adb5bd\"");
  }

  void draw(const MapUnknown& /*unknown*/) {}
  void draw(const MapHeader& /*header*/) {}
  void draw(const MapMeasures& /*measures*/) {}

  void draw(const MapObstacle& obstacle) {
    layers_.bodies += disc(obstacle.centre, obstacle.radius_m, kObstacle);
  }

  void draw(const MapObject& object) {
    const char* dashes = object.mobility == Mobility::Container ? " stroke-dasharray=\"4 2\"" : "";
    const double opacity = object.mobility == Mobility::Fixed ? 0.6 : 0.9;
    layers_.bodies += disc(object.centre, object.radius_m,
                           "fill=\"" + colour_name(object.colour) + "\" fill-opacity=\"" +
                               svg_number(opacity) + "\" stroke=\"#343a40\"" + dashes);
  }

  void draw(const MapHallway& hallway) {
    layers_.floors = points("polygon", hallway.outline, kHallway) + layers_.floors;
    layers_.lines += points("polyline", hallway.centre_line,
                            "fill=\"none\" stroke=\"#9fb7cc\" stroke-dasharray=\"2 5\"");
    name_area(hallway.name, hallway.outline);
  }

  void draw(const MapShape& shape) {
    switch (shape.kind) {
      case ShapeKind::Room:
        layers_.floors += points("polygon", shape.points, kRoom);
        name_area(shape.name, shape.points);
        break;
      case ShapeKind::AssemblyArea:
      case ShapeKind::BattlePosition:
      case ShapeKind::Zone:
        draw_ground(shape);
        break;
      case ShapeKind::Wall:
        name_line(shape);
        break;
      case ShapeKind::Door:
        layers_.walls += svg_line(at(shape.points.at(0)), at(shape.points.at(1)), kDoor);
        break;
      case ShapeKind::Gap:
        layers_.walls += svg_line(at(shape.points.at(0)), at(shape.points.at(1)), kGap);
        break;
      case ShapeKind::Boundary:
        draw_boundary(shape);
        break;
      default:
        draw_measure(shape);
    }
  }

  void draw_boundary(const MapShape& shape) {
    if (wall_kind_ != ShapeKind::Boundary) {
      layers_.lines += points("polyline", shape.points, kLine);
    }
    name_line(shape);
  }

  void draw_ground(const MapShape& shape) {
    if (shape.points.size() < 3) {
      draw_measure(shape);
      return;
    }
    layers_.floors += points("polygon", shape.points, kGround);
    name_area(shape.name, shape.points);
  }

  /// A point as a ring or a cross, a line as a line.
  void draw_measure(const MapShape& shape) {
    const MapPoint& first = shape.points.front();
    if (shape.points.size() > 1) {
      layers_.lines += points("polyline", shape.points, kLine);
    } else if (shape.size_m.value_or(0.0) > 0.0) {
      layers_.lines += disc(first, *shape.size_m, "fill=\"none\" stroke=\"#1864ab\"");
    }
    const SvgPlace p = at(first);
    constexpr std::string_view kCross = "stroke=\"#1864ab\" stroke-width=\"1.5\"";
    layers_.bodies += svg_line({p.x - 4, p.y}, {p.x + 4, p.y}, kCross) +
                      svg_line({p.x, p.y - 4}, {p.x, p.y + 4}, kCross);
    const bool start = shape.kind == ShapeKind::PassagePoint && is_start_place(shape.name);
    if (start || is_shown(shape.name)) {
      std::string& names = point_names_[{first.x_m, first.y_m}];
      names += (names.empty() ? "" : ", ") + (start ? "Start" : shape.name);
    }
  }

  /// Points in the same place share a line.
  void name_points() {
    for (const auto& [place, names] : point_names_) {
      const SvgPlace p = at({place.first, place.second});
      name({p.x + 7, p.y - 7}, names, 11.0, "fill=\"#1864ab\"");
    }
  }

  void name_line(const MapShape& shape) {
    if (is_shown(shape.name)) {
      const SvgPlace a = at(shape.points[0]);
      const SvgPlace b = at(shape.points[1]);
      name({(a.x + b.x) / 2, (a.y + b.y) / 2 - 4}, shape.name, 10.0,
           "text-anchor=\"middle\" fill=\"#5c6670\"");
    }
  }

  /// In the middle of what the area spans, small enough to fit.
  void name_area(const std::string& text, const std::vector<MapPoint>& outline) {
    if (!is_shown(text)) return;
    const auto [west, east] =
        std::minmax_element(outline.begin(), outline.end(),
                            [](const MapPoint& a, const MapPoint& b) { return a.x_m < b.x_m; });
    const auto [south, north] =
        std::minmax_element(outline.begin(), outline.end(),
                            [](const MapPoint& a, const MapPoint& b) { return a.y_m < b.y_m; });
    const double room = scale_ * (east->x_m - west->x_m);
    const double size =
        std::clamp(room / (kLetter * static_cast<double>(text.size() + 1)), 7.0, 14.0);
    const SvgPlace middle = at({(west->x_m + east->x_m) / 2, (south->y_m + north->y_m) / 2});
    name({middle.x, middle.y + size / 3}, text, size, "text-anchor=\"middle\" fill=\"#5f4b1b\"");
  }

  /// With a light rim, so that it can be read on anything.
  void name(SvgPlace place, const std::string& text, double size, std::string_view style) {
    constexpr std::string_view kRim =
        " stroke=\"#ffffff\" stroke-opacity=\"0.75\" stroke-width=\"3\" paint-order=\"stroke\" "
        "stroke-linejoin=\"round\" ";
    layers_.names +=
        svg_text(place, text,
                 "font-size=\"" + svg_number(size) + '"' + std::string(kRim) + std::string(style));
  }

  /// 1, 2 or 5 times a power of ten, at most a quarter of the picture.
  [[nodiscard]] std::string bar() const {
    const double most_m = 0.25 * (width_ - 2.0 * kEdge) / scale_;
    double length_m = std::pow(10.0, std::floor(std::log10(std::max(most_m, 1e-6))));
    length_m *= 5.0 * length_m <= most_m ? 5.0 : (2.0 * length_m <= most_m ? 2.0 : 1.0);
    const double y = height_ - 14.0;
    const double right = kEdge + scale_ * length_m;
    constexpr std::string_view kInk = "stroke=\"#26303a\" stroke-width=\"2\"";
    std::string number = svg_number(length_m);
    number.erase(number.find_last_not_of('0') + 1);
    number = number.ends_with('.') ? number.substr(0, number.size() - 1) : number;
    return svg_line({kEdge, y}, {right, y}, kInk) + svg_line({kEdge, y - 4}, {kEdge, y + 4}, kInk) +
           svg_line({right, y - 4}, {right, y + 4}, kInk) +
           svg_text({right + 8, y + 4}, number + " m", "font-size=\"12\" fill=\"#26303a\"");
  }

  const OverlayMap& map_;
  ShapeKind wall_kind_ = wall_kind(map_);
  MapExtent extent_;
  double scale_ = 1.0;
  double width_ = 0.0;
  double height_ = 0.0;
  Layers layers_;
  std::map<std::pair<double, double>, std::string> point_names_;
};

}  // namespace

std::string picture_of(const OverlayMap& map) { return Drawing(map).text(); }

}  // namespace tacit
