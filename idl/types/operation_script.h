#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "idl/types/parameters.h"

namespace tacit {

/// What an operation is made from: who carries out which mission on which map.
///
/// Robots are numbered through: first those of `mission`, then those of `extras`, each in the
/// order of its file. The world reads the map, a robot its part of a mission and where it starts;
/// no robot reads the map.
struct OperationScript {
  std::string mission;           ///< In the Configuration Description Language.
  std::string extras;            ///< As `mission`, of robots that are not of the team; empty: none.
  std::int64_t extra_count = 0;  ///< How many of the robots are those.
  std::string extra_colour = "red";         ///< "red" is an enemy's, "blue" a friend's.
  std::string map;                          ///< An overlay.
  std::vector<std::vector<double>> starts;  ///< Rows of x, y [m] and heading [deg] on the map, one
                                            ///< per robot.
};

/// Section `operation`.
void describe(OperationScript& script, ParameterVisitor& visitor);

}  // namespace tacit
