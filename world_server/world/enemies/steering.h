#pragma once

#include "idl/types/ids.h"
#include "idl/types/random.h"
#include "world_server/world/sensing/near_map.h"
#include "world_server/world/terrain.h"

namespace tacit {

/// A heading that somebody draws by chance and holds for a while.
struct Wander {
  Stream chance;     ///< Its own.
  WorldVec heading;  ///< Unit length once drawn.
  Tick until = 0;    ///< Tick at which it is drawn anew.
};

/// What the ways of all enemies have in common: they avoid obstacles and inner walls by the same
/// repulsion as the robots, never dawdle, and are held off the straight line by chance.
class Steering {
 public:
  struct Config {
    double avoid_reach_m = 0.0;
    double avoid_margin_m = 0.0;
    Tick wander_ticks = 1;  ///< How long a random heading is held.
  };
  /// Keeps a reference to `terrain`.
  Steering(const Terrain& terrain, const Config& config);

  /// Draws the heading anew when its time is over.
  void refresh(Wander& wander, Tick tick) const;
  /// The direction, of unit length, of somebody at `place_m` who is driven by `purpose`; zero when
  /// the pushes cancel out.
  [[nodiscard]] WorldVec direction(const WorldVec& purpose, const WorldVec& place_m) const;

 private:
  [[nodiscard]] WorldVec away_from_obstacles(const WorldVec& place_m) const;

  Config config_;
  const Terrain* terrain_;
  NearMap near_;
};

/// `hold_s` in whole ticks, at least 1.
[[nodiscard]] Tick held_ticks(double hold_s, double tick_s);

}  // namespace tacit
