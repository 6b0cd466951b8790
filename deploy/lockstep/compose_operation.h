#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "idl/types/operation_script.h"

namespace tacit {

/// A text and what errors call it, mostly a file.
struct NamedText {
  std::string text;
  std::string name;
};

/// What an operation is to be made from.
struct OperationWish {
  NamedText mission;
  NamedText map;
  std::optional<NamedText> extras;    ///< A mission for robots beside the team.
  std::string extra_colour = "red";   ///< "red" or "blue".
  std::optional<std::size_t> robots;  ///< Of the team; else as many as the mission has.
  /// Rows of x [m], y [m], heading [deg] on the map for the team's first robots, in place of the
  /// map's start place.
  std::vector<std::vector<double>> starts;
  std::vector<std::vector<double>> extra_starts;  ///< In the same way for the extras.
};

/// The script of such an operation.
///
/// A goal that the mission gives by the name of a point, `%Goal_Location = {Gate}`, becomes that
/// point's place. With more robots than the mission has, its last one's part is played by all the
/// rest. The team starts in file at the map's start place, in the middle of the map when it has
/// none, the first robot at the head; an extra robot starts at its first goal. All face their first
/// goal, else along the hallway that they are in, the longer way, else the middle of the map.
///
/// Throws ConfigError, with every place, when mission or map cannot be used or when there is no
/// room for a robot.
[[nodiscard]] OperationScript compose_operation(const OperationWish& wish);

}  // namespace tacit
