#pragma once

#include <cstdint>
#include <span>
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
  /// True when nothing near the eye could hide anything.
  [[nodiscard]] bool open() const { return discs_.empty() && walls_.empty(); }
  /// True when nothing hides the point at `offset_m` from the eye.
  [[nodiscard]] bool clear(const WorldVec& offset_m) const;

 private:
  /// Two discs relative to the eye, tested at once on vector registers. An unused place has a
  /// negative size and hides nothing.
  struct DiscPair {
    Eigen::Array2d x{0.0, 0.0};
    Eigen::Array2d y{0.0, 0.0};
    Eigen::Array2d r2{-1.0, -1.0};
  };
  void gather_discs(const WorldVec& eye_m, std::span<const std::uint16_t> near);
  [[nodiscard]] bool hidden_by_disc(const WorldVec& offset_m) const;
  [[nodiscard]] bool hidden_by_wall(const WorldVec& offset_m) const;

  const Terrain* terrain_;
  NearMap near_;
  Blockers blockers_;
  std::vector<DiscPair> discs_;
  std::vector<Wall> walls_;
};

}  // namespace tacit
