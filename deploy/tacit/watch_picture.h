#pragma once

#include <map>
#include <string>

#include "idl/types/roster.h"
#include "idl/types/telemetry.h"
#include "idl/types/world_view.h"
#include "world_server/world/terrain.h"

namespace tacit {

/// What is known of a run that is watched; absent parts have not come yet.
struct Watched {
  std::string name;
  Terrain terrain;
  RunStatus status;
  WorldView view;
  std::map<RobotId, Telemetry> telemetry;
};

/// The run for a terminal: a line on how it stands, the map in letters, a line for each robot, at
/// most so wide and high.
[[nodiscard]] std::string watch_picture(const Watched& watched, int columns, int rows);

}  // namespace tacit
