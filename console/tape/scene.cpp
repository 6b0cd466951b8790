#include "console/tape/scene.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace tacit {
namespace {

using Paint = Marker::Paint;

constexpr Paint kWall{0.55F, 0.55F, 0.6F, 1.0F};
constexpr Paint kGrey{0.5F, 0.5F, 0.5F, 1.0F};
constexpr Paint kMine{1.0F, 0.55F, 0.0F, 1.0F};
constexpr Paint kFocus{0.95F, 0.85F, 0.2F, 0.8F};
/// In the order of EnemyKind.
constexpr std::array<Paint, 3> kEnemies{
    {{0.9F, 0.1F, 0.1F, 1.0F}, {0.95F, 0.6F, 0.6F, 1.0F}, {0.6F, 0.1F, 0.6F, 1.0F}}};
/// In the order of Colour.
constexpr std::array<Paint, 12> kColours{{{1.0F, 1.0F, 1.0F, 1.0F},
                                          {0.2F, 0.4F, 1.0F, 1.0F},
                                          {0.9F, 0.1F, 0.1F, 1.0F},
                                          {1.0F, 0.9F, 0.1F, 1.0F},
                                          {1.0F, 0.55F, 0.0F, 1.0F},
                                          {0.6F, 0.1F, 0.6F, 1.0F},
                                          {0.1F, 0.7F, 0.2F, 1.0F},
                                          {0.1F, 0.1F, 0.1F, 1.0F},
                                          {0.2F, 0.55F, 0.35F, 1.0F},
                                          {0.55F, 0.35F, 0.15F, 1.0F},
                                          {0.55F, 0.8F, 1.0F, 1.0F},
                                          {0.5F, 0.5F, 0.5F, 1.0F}}};
constexpr double kLineWidth_m = 0.1;
/// Low bodies, so that a view from above shows all.
constexpr double kBody_m = 0.3;
/// Smaller ones could not be seen on a field of 100 m and more. [ours]
constexpr double kSmallestShown_m = 0.5;

Marker list(const char* group, Marker::Type type, double size_m) {
  Marker marker;
  marker.group = group;
  marker.type = type;
  marker.scale = {size_m, size_m, size_m};
  return marker;
}

void add_line(Marker& lines, double x1, double y1, double x2, double y2) {
  lines.points.push_back({x1, y1, 0.0});
  lines.points.push_back({x2, y2, 0.0});
}

Marker disc(const char* group, int id, const Scenery::Place& place, const Paint& paint) {
  Marker marker = list(group, Marker::Type::Cylinder, 2 * place.radius_m);
  marker.id = id;
  marker.position = {place.x_m, place.y_m, 0.0};
  marker.scale.z = kBody_m;
  marker.paint = paint;
  return marker;
}

Marker walls(const Scenery& scenery) {
  Marker lines = list("walls", Marker::Type::LineList, kLineWidth_m);
  lines.paint = kWall;
  for (const auto& row : scenery.walls) {
    if (row.size() == 4) add_line(lines, row[0], row[1], row[2], row[3]);
  }
  if (scenery.border_walls) {
    const double x = scenery.width_m;
    const double y = scenery.height_m;
    add_line(lines, 0, 0, x, 0);
    add_line(lines, x, 0, x, y);
    add_line(lines, x, y, 0, y);
    add_line(lines, 0, y, 0, 0);
  }
  return lines;
}

/// The same with nothing in it would be a fault to some programs.
Marker or_none(Marker list) {
  if (list.points.empty()) list.action = Marker::Action::Delete;
  return list;
}

void add_robot(std::vector<Marker>& scene, const ViewedRobot& robot, double radius_m) {
  const auto& at = robot.pose.position_m;
  const double shown_m = std::max(radius_m, kSmallestShown_m);
  const bool well = robot.present && robot.able;
  const Paint paint = well ? kColours[static_cast<std::size_t>(robot.colour) % 12] : kGrey;
  Marker body = disc("robots", robot.robot.value, {at.x(), at.y(), shown_m}, paint);
  Marker arrow = body;
  arrow.group = "headings";
  arrow.type = Marker::Type::Arrow;
  arrow.scale = {4 * shown_m, shown_m / 2, shown_m / 2};
  const double half_rad = robot.pose.heading.rad() / 2;
  arrow.turn_cos = std::cos(half_rad);
  arrow.turn_sin = std::sin(half_rad);
  Marker label = body;
  label.group = "names";
  label.type = Marker::Type::Text;
  label.position.z = 1.0;
  label.scale.z = 1.0;
  label.text = std::to_string(robot.robot.value);
  scene.insert(scene.end(), {std::move(body), std::move(arrow), std::move(label)});
}

Marker enemies(const WorldView& view) {
  Marker spheres = list("enemies", Marker::Type::SphereList, 2 * kSmallestShown_m);
  for (const ViewedEnemy& enemy : view.enemies) {
    spheres.points.push_back({enemy.position_m.x(), enemy.position_m.y(), 0.0});
    spheres.paints.push_back(kEnemies[static_cast<std::size_t>(enemy.kind) % 3]);
  }
  return or_none(std::move(spheres));
}

Marker mines(const WorldView& view) {
  Marker spheres = list("mines", Marker::Type::SphereList, kSmallestShown_m);
  spheres.paint = kMine;
  for (const ViewedMine& mine : view.mines) {
    spheres.points.push_back({mine.position_m.x(), mine.position_m.y(), 0.0});
  }
  return or_none(std::move(spheres));
}

Marker objects(const WorldView& view) {
  Marker spheres = list("objects", Marker::Type::SphereList, kSmallestShown_m);
  for (const ViewedObject& object : view.objects) {
    spheres.points.push_back({object.position_m.x(), object.position_m.y(), 0.0});
    spheres.paints.push_back(kColours[static_cast<std::size_t>(object.colour) % 12]);
  }
  return or_none(std::move(spheres));
}

}  // namespace

std::vector<Marker> still_scene(const Scenery& scenery) {
  std::vector<Marker> scene{or_none(walls(scenery))};
  int id = 0;
  for (const auto& row : scenery.discs) {
    if (row.size() == 3) scene.push_back(disc("obstacles", ++id, {row[0], row[1], row[2]}, kGrey));
  }
  if (scenery.focus) scene.push_back(disc("place", 1, *scenery.focus, kFocus));
  return scene;
}

std::vector<Marker> moving_scene(const WorldView& view, double robot_radius_m) {
  std::vector<Marker> scene;
  scene.reserve(3 * view.robots.size() + 3);
  for (const ViewedRobot& robot : view.robots) add_robot(scene, robot, robot_radius_m);
  scene.push_back(enemies(view));
  scene.push_back(mines(view));
  scene.push_back(objects(view));
  return scene;
}

}  // namespace tacit
