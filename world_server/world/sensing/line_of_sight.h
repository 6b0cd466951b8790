#pragma once

#include <vector>

#include "world_server/world/sensing/near_map.h"
#include "world_server/world/terrain.h"

namespace tacit {

/// Whether something hides one point from another.
///
/// An eye looks at many things from one place, so what could be in the way is gathered once per
/// place. A disc hides what lies behind it when the line crosses its interior. Eyes and things lie
/// outside all discs, so only a disc whose centre is abreast of the line can cross it.
class LineOfSight {
 public:
  struct Blockers {
    bool obstacles = true;
    bool walls = true;
  };

  /// Keeps a reference to `terrain`. Lines are at most `range_m` long.
  LineOfSight(const Terrain& terrain, double range_m, Blockers blockers);

  /// The lines asked for from now on start at `eye_m`.
  void look_from(const WorldVec& eye_m);
  /// True when nothing hides the point at `offset_m` from the eye.
  [[nodiscard]] bool clear(const WorldVec& offset_m) const;

 private:
  [[nodiscard]] bool hidden_by_disc(const WorldVec& offset_m) const;
  [[nodiscard]] bool hidden_by_wall(const WorldVec& offset_m) const;

  const Terrain* terrain_;
  NearMap near_;
  Blockers blockers_;
  // The gathered discs, relative to the eye, one list per number so that the test of a line
  // against all of them runs on vector registers.
  std::vector<double> disc_x_;
  std::vector<double> disc_y_;
  std::vector<double> disc_r2_;
  std::vector<Wall> walls_;
};

}  // namespace tacit
