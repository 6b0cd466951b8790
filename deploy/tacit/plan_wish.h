#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "idl/overlay/plan.h"
#include "idl/types/plan_request.h"

namespace tacit {

/// What a person types to have a mission planned. Empty texts were not given.
struct PlanWish {
  std::string map;
  std::vector<std::string> tasks;  ///< "biohazard@12,8/outdoor".
  std::optional<int> robots;
  bool enemy = false;
  double max_velocity_mps = PlanRequest().max_velocity_mps;
  double aggressiveness = PlanRequest().aggressiveness;
  std::size_t top = PlanRequest().top;
  bool naive = false;
};

/// The task that `text` places on a map: KIND@X,Y in metres as the map's file counts, or KIND@NAME
/// of a point, room, hallway or area of the map; behind it what is wanted of this task alone, each
/// after a slash: `indoor` or `outdoor`, `landmarks` or `maps`, `enemy` or `no-enemy`. Throws
/// ConfigError with what was found and what was wanted.
[[nodiscard]] PlacedTask task_of(std::string_view text, const MapPlan& map);

/// Throws ConfigError as `task_of` does; what no plan can be made for is for the wizard to say.
[[nodiscard]] PlanRequest request_of(const PlanWish& wish, const MapPlan& map);

}  // namespace tacit
