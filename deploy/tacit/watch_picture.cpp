#include "deploy/tacit/watch_picture.h"

#include <algorithm>
#include <cstdio>
#include <vector>

#include "deploy/tacit/text_canvas.h"

namespace tacit {
namespace {

constexpr const char* kPhases[] = {"gathering", "running", "paused", "ended", "stopped"};
constexpr int kRobotLines = 12;
/// A terminal of that height has room for the map alone.
constexpr int kLeastMapRows = 8;

MapPoint at(const WorldVec& p) { return {p.x(), p.y()}; }

/// 1 to 9, then letters, then `@`.
char letter_of(RobotId robot) {
  if (robot.value < 10) return static_cast<char>('0' + robot.value);
  if (robot.value < 36) return static_cast<char>('A' + robot.value - 10);
  return '@';
}

std::string map_of(const Watched& watched, int columns, int rows) {
  const Terrain& terrain = watched.terrain;
  TextCanvas canvas({terrain.width_m, terrain.height_m}, columns - 2, rows - 2);
  for (const Disc& disc : terrain.obstacles) canvas.disc(at(disc.centre_m), disc.radius_m, 'o');
  for (const Wall& wall : terrain.walls) canvas.line(at(wall.from_m), at(wall.to_m), '#');
  for (const ViewedMine& mine : watched.view.mines) canvas.point(at(mine.position_m), '*');
  for (const ViewedObject& object : watched.view.objects) canvas.point(at(object.position_m), '+');
  for (const ViewedEnemy& enemy : watched.view.enemies) canvas.point(at(enemy.position_m), 'x');
  for (const ViewedRobot& robot : watched.view.robots) {
    canvas.point(at(robot.pose.position_m), letter_of(robot.robot));
  }
  return canvas.text();
}

std::string headline(const Watched& watched) {
  const RunStatus& status = watched.status;
  char text[256];
  std::snprintf(text, sizeof text, "%s  %s  tick %llu of %llu  %.1f s  robots %u of %u\n",
                watched.name.c_str(), kPhases[static_cast<std::size_t>(status.phase)],
                static_cast<unsigned long long>(std::max(status.tick, watched.view.tick)),
                static_cast<unsigned long long>(status.last_tick), watched.view.time_s,
                static_cast<unsigned>(status.present), static_cast<unsigned>(status.robots));
  return text;
}

std::string robot_line(const Watched& watched, const ViewedRobot& robot) {
  std::string doing;
  const auto heard = watched.telemetry.find(robot.robot);
  if (heard != watched.telemetry.end()) {
    for (const std::string* word :
         {&heard->second.role, &heard->second.state, &heard->second.situation}) {
      if (!word->empty()) doing += (doing.empty() ? "" : ", ") + *word;
    }
  }
  char text[256];
  std::snprintf(text, sizeof text, "%c  %7.1f %7.1f m  %4.2f m/s  %s%s%s%s\n",
                letter_of(robot.robot), robot.pose.position_m.x(), robot.pose.position_m.y(),
                robot.velocity_mps.norm(), doing.c_str(), robot.holding ? "  carries" : "",
                robot.able ? "" : "  disabled", robot.present ? "" : "  lost");
  return text;
}

}  // namespace

std::string watch_picture(const Watched& watched, int columns, int rows) {
  const int robots = std::min<int>(kRobotLines, static_cast<int>(watched.view.robots.size()));
  const int for_map = std::max(kLeastMapRows, rows - robots - 3);
  std::string text = headline(watched) + map_of(watched, columns, for_map);
  for (int i = 0; i < robots && rows - for_map > 3; ++i) {
    text += robot_line(watched, watched.view.robots[static_cast<std::size_t>(i)]);
  }
  return text;
}

}  // namespace tacit
