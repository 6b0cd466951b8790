#pragma once

#include <vector>

#include "console/tape/markers.h"
#include "console/tape/scenery.h"
#include "idl/types/world_view.h"

namespace tacit {

/// What stands still, for a 3D view: walls, the area's border, obstacles, the target or base.
[[nodiscard]] std::vector<Marker> still_scene(const Scenery& scenery);

/// What moves or comes and goes: robots with their heading and number, enemies, mines, objects. A
/// robot that is disabled or whose agent is lost is grey.
[[nodiscard]] std::vector<Marker> moving_scene(const WorldView& view, double robot_radius_m);

}  // namespace tacit
