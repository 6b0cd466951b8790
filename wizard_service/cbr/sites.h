#pragma once

#include <vector>

#include "idl/types/plan_request.h"
#include "wizard_service/cbr/changes.h"
#include "wizard_service/cbr/propose.h"
#include "wizard_service/cbr/terrain.h"

namespace tacit::cbr {

/// Where a sub-mission begins, and how to get there.
struct Site {
  MapPoint at;                   ///< In the map's frame.
  std::vector<MapPoint> way;     ///< Without where it begins; the last is `at`. Never empty.
  MapPoint outside;              ///< Where the way there came into the building from; else `at`.
  bool out_of_building = false;  ///< It begins wherever in a building the task before ended.
};

/// How far behind each other robots stop that come to one place, in metres. [ours]
inline constexpr double kSpacing = 0.8;

/// Criticizes the places of the tasks of `squad`, which are done one after another from the map's
/// start, and finds the ways between them. A place in a wall or out of reach moves
/// to the nearest one that can be reached, a task for a building that was placed in the open into
/// the hallway of the nearest one. Each change is told.
[[nodiscard]] std::vector<Site> place_tasks(const PlanRequest& request, const Squad& squad,
                                            const Terrain& terrain, Changes& changes);

/// Whether a task is done by going through a building.
[[nodiscard]] bool is_for_building(const PlacedTask& task);

}  // namespace tacit::cbr
