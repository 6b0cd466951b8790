#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "idl/types/frames.h"
#include "world_server/world/sensing/near_map.h"
#include "world_server/world/terrain.h"

namespace tacit {

/// Finds out which bodies something is near to, so that the rest of them need no collision test.
class Encounters {
 public:
  /// A body before a step.
  struct Body {
    WorldVec place_m;
    double radius_m = 0.0;
    bool near = false;  ///< As it was found in the step before.
  };

  /// Inner walls are `wall_half_thickness_m` thick to either side.
  Encounters(Terrain terrain, double wall_half_thickness_m);

  /// Sets `near` of every body that could touch another one, an obstacle or a wall in a step in
  /// which no body goes further than `way_m`. One that was near stays so for a little longer, so
  /// that it does not come and go with every change of speed.
  void find(std::span<Body> bodies, double way_m);

 private:
  [[nodiscard]] bool near_terrain(const Body& body, double gap_m) const;
  [[nodiscard]] bool near_border(const Body& body, double gap_m) const;
  void sort(std::span<const Body> bodies);
  void find_pairs(std::span<const Body> bodies, double way_m);

  Terrain terrain_;
  double wall_half_thickness_m_;
  NearMap near_map_;
  std::vector<std::uint32_t> order_;  ///< Of the bodies, by x.
  std::vector<std::uint8_t> found_;
};

}  // namespace tacit
