#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "idl/overlay/plan.h"
#include "idl/types/frames.h"
#include "idl/types/percept.h"
#include "world_server/world/digest.h"
#include "world_server/world/missions/reach.h"

namespace tacit {

/// The ways into a map's rooms, numbered from 1: its doors, unless they are closed, then its gaps,
/// each in the map's order. A gap in a door is that door; an opening without a room on either side
/// is none. Everybody sees the marks on them.
class Doorways {
 public:
  Doorways(const MapPlan& plan, Doors doors);

  /// Fills `out` with those in reach of the robot at `eye`, the nearest first, no more than a
  /// percept holds.
  void see(const WorldPose& eye, const Reach& reach, std::vector<SeenDoorway>& out);
  /// The nearest one in reach, the lowest number on a tie; 0 when there is none.
  [[nodiscard]] std::uint32_t nearest(const Reach& reach) const;
  /// Puts a mark on a doorway, or takes it off; false when it was so before.
  bool mark(std::uint32_t number, bool marked);

  void add_to(Digest& digest) const;

 private:
  struct Doorway {
    WorldVec middle_m;
    WorldVec jamb_m;  ///< From the middle.
    bool marked = false;
  };

  std::vector<Doorway> doorways_;
  std::vector<std::pair<double, std::size_t>> seen_;  ///< Scratch, kept for its memory.
};

}  // namespace tacit
