#include "idl/types/operation_script.h"

#include <array>
#include <string_view>

namespace tacit {

void describe(OperationScript& script, ParameterVisitor& visitor) {
  static constexpr std::array<std::string_view, 2> kColours{"red", "blue"};
  static constexpr std::array<std::string_view, 3> kStart{"x_m", "y_m", "heading_deg"};
  visitor.section("operation", "Who carries out which mission on which map.");
  visitor.text("mission", script.mission,
               {"", "The team's mission in the Configuration Description Language. [MissionLab]"});
  visitor.text("extras", script.extras,
               {"", "A mission for robots beside the team, a sentry's perhaps. [MissionLab]"});
  visitor.integer("extra_count", script.extra_count, {0, 1024},
                  {"", "How many of the robots, the last ones, carry out `extras`. [MissionLab]"});
  visitor.choice("extra_colour", script.extra_colour, kColours,
                 {"", "How those robots are painted: red is an enemy. [MissionLab]"});
  visitor.text("map", script.map, {"", "The map, an overlay. [MissionLab]"});
  visitor.rows(
      "starts", script.starts, kStart, {-1e6, 1e6},
      {"", "Where on the map each robot stands at first and faces; it is told so. [MissionLab]"});
}

}  // namespace tacit
