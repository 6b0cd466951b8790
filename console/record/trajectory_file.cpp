#include "console/record/trajectory_file.h"

#include <array>
#include <charconv>

namespace tacit {
namespace {

template <class Number>
void append_number(std::string& out, Number value) {
  std::array<char, 32> digits{};
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr;
  out.append(digits.data(), end);
}

/// All columns but the last.
void append_body(std::string& out, Tick tick, std::uint32_t id, const char* kind) {
  append_number(out, tick);
  out.append(1, ',');
  append_number(out, id);
  out.append(1, ',').append(kind).append(1, ',');
}

void append_place(std::string& out, const WorldVec& position_m) {
  append_number(out, position_m.x());
  out.append(1, ',');
  append_number(out, position_m.y());
  out.append(1, ',');
}

}  // namespace

TrajectoryFile::TrajectoryFile(const std::filesystem::path& file) : file_(file) {
  if (file_.size() == 0) {
    file_.append(kTrajectoryColumns);
  }
}

void append_trajectory_lines(std::string& out, const WorldView& view) {
  for (const ViewedRobot& robot : view.robots) {
    append_body(out, view.tick, robot.robot.value, "robot");
    append_place(out, robot.pose.position_m);
    append_number(out, robot.pose.heading.rad());
    out.append(1, '\n');
  }
  for (const ViewedEnemy& enemy : view.enemies) {
    append_body(out, view.tick, enemy.enemy.value, name(enemy.kind));
    append_place(out, enemy.position_m);
    out.append(1, '\n');
  }
}

void TrajectoryFile::append(const WorldView& view) {
  lines_.clear();
  append_trajectory_lines(lines_, view);
  file_.append(lines_);
}

}  // namespace tacit
