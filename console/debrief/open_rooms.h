#pragma once

#include <cstdint>
#include <vector>

#include "idl/overlay/ground.h"
#include "idl/overlay/plan.h"

namespace tacit {

/// By index of the map's rooms, whether there is a way in: a gap, or with open doors a door, on the
/// outline. A gap leads through outlines up to half a metre before and behind its middle. [ours]
[[nodiscard]] std::vector<bool> open_rooms(const MapPlan& plan, Doors doors);

/// For each of `points`, the number, from 1, of the room in which it lies, the first of several; 0
/// for none.
[[nodiscard]] std::vector<std::uint32_t> rooms_at(const MapPlan& plan,
                                                  const std::vector<MapPoint>& points);

}  // namespace tacit
