#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "idl/overlay/plan.h"
#include "idl/types/frames.h"

namespace tacit {

/// Finds room for robots on a map, in the world's frame.
class StartPlaces {
 public:
  /// Borrows `plan`.
  explicit StartPlaces(const MapPlan& plan) : plan_(&plan) {}

  /// Where the team starts: the map's start place, else its middle.
  [[nodiscard]] WorldVec team_m() const;
  /// Which way a robot at `place_m` faces at first: to its goal, else along the hallway that it is
  /// in, the longer way, else to the middle of the map.
  [[nodiscard]] Heading facing(const WorldVec& place_m,
                               const std::optional<WorldVec>& goal_m) const;
  /// A free place nearest to `wanted_m` that can be reached from there in a straight line; empty
  /// when there is none within 20 m. The place is taken from now on.
  [[nodiscard]] std::optional<WorldVec> take(const WorldVec& wanted_m);

 private:
  [[nodiscard]] bool free(const WorldVec& place_m) const;
  [[nodiscard]] bool in_sight(const WorldVec& from_m, const WorldVec& to_m) const;

  const MapPlan* plan_;
  std::vector<WorldVec> taken_m_;
};

}  // namespace tacit
