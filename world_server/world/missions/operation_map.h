#pragma once

#include <cstddef>
#include <optional>
#include <string_view>

#include "idl/overlay/plan.h"
#include "idl/types/frames.h"
#include "idl/types/percept.h"
#include "world_server/world/world_config.h"

namespace tacit {

/// A map has at most so many rooms, hallways, doorways, objects and points each, so that a tick
/// stays short. [ours]
inline constexpr std::size_t kMostMapThings = 10'000;

[[nodiscard]] inline WorldVec place_of(const MapPoint& p) { return {p.x_m, p.y_m}; }

/// What the map of an operation says; nothing when it has none or when the mission is another.
///
/// Throws ConfigError that names every place where the map's text is wrong, and when there is too
/// much of something.
[[nodiscard]] MapPlan operation_plan(const WorldConfig& config);

/// Makes the area that of the operation's map: its size, and its walls and obstacles beside those
/// that are there already. A second time changes nothing.
void take_ground(const MapPlan& plan, WorldConfig& config);

/// The colour that a map calls `name`, whatever the case of its letters.
[[nodiscard]] std::optional<Colour> map_colour(std::string_view name);

}  // namespace tacit
