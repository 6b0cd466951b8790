#pragma once

#include <string>
#include <utility>
#include <vector>

#include "tests/world/forage_field.h"

namespace tacit {

using Starts = std::vector<std::vector<double>>;

/// 20 m by 12 m. A hallway runs from west to east, 4 m to 6 m from the south, along y = 5. North of
/// it lie room A, west of x = 10, with door 1 at x 5 to 7, and room B with door 2 at x 13 to 14. A
/// gap, doorway 3, leads south at x = 16 into room C, which lies east of x = 12; west of it is the
/// open.
inline const std::string kFloor =
    "MISSION-AREA 20 12\n"
    "CONTROL MEASURES:\n"
    "PP StartPlace 2 5 0.2\n"
    "PP Far 18 5 0.2\n"
    "WALL north 0 6 20 6\n"
    "WALL south 0 4 20 4\n"
    "WALL middle 10 6 10 12\n"
    "DOOR a 5 6 7 6\n"
    "DOOR b 13 6 14 6\n"
    "GAP g 16 3.9 16 4.1 1.5\n"
    "ROOM A 0 6 10 6 10 12 0 12\n"
    "ROOM B 10 6 20 6 20 12 10 12\n"
    "ROOM C 12 0 20 0 20 4 12 4\n"
    "HALLWAY h CENTERLINE 0 5 20 5 WIDTH 2 EXTENTS 0 4 20 4 20 6 0 6\n";

/// On the floor and with `more` on its map, robots that start at rows of x, y, heading.
inline WorldConfig on_floor(const Starts& starts, const std::string& more = "") {
  WorldConfig config = world_defaults(MissionKind::Operation);
  config.robots.count = static_cast<std::int64_t>(starts.size());
  config.operation.script.map = kFloor + more;
  config.operation.script.starts = starts;
  return config;
}

/// The last `extras` robots are no team.
inline WorldConfig with_extras(WorldConfig config, std::int64_t extras,
                               const std::string& colour = "red") {
  config.operation.script.extra_count = extras;
  config.operation.script.extra_colour = colour;
  return config;
}

inline Command about(std::uint16_t robot, Act act, std::optional<Colour> colour) {
  Command command = acting(robot, act);
  command.about = colour;
  return command;
}

inline Command saying(std::uint16_t robot, Act act, std::string_view word) {
  Command command = acting(robot, act);
  command.word = Word(word);
  return command;
}

/// Steps `field` so often.
inline void repeat(Field& field, int times, const std::vector<Command>& commands) {
  for (int i = 0; i < times; ++i) {
    field.step(commands);
  }
}

inline bool sees(const Percept& percept, Kind kind, Colour colour) {
  return seen(percept, kind, colour) > 0;
}

}  // namespace tacit
