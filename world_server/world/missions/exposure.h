#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "world_server/world/missions/mission.h"
#include "world_server/world/sensing/line_of_sight.h"

namespace tacit {

/// Which robots of the team stand in the sight of which enemies. A disabled enemy sees nobody.
class Exposure {
 public:
  /// The first `team` of `robots` robots are the team, the others its enemies.
  Exposure(double range_m, std::size_t team, std::size_t robots);

  /// Says who has come into, or gone out of, whose sight. `sight` is turned on the way.
  void watch(Stage& stage, LineOfSight& sight);
  void add_to(Digest& digest) const;

 private:
  void watch(std::size_t enemy, Stage& stage, const LineOfSight& sight);

  double range_m_;
  std::size_t team_;
  std::vector<std::uint8_t> exposed_;  ///< Enemy by enemy, robot by robot.
};

}  // namespace tacit
