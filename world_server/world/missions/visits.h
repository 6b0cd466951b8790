#pragma once

#include <cstdint>
#include <vector>

#include "world_server/world/missions/mission.h"
#include "world_server/world/missions/sites.h"

namespace tacit {

/// In which room or hallway each robot is, and which points of the map it has been at.
class Visits {
 public:
  /// A robot has reached a point from `reach_m`, or from the point's own radius if that is more.
  Visits(const MapPlan& plan, double reach_m, const Stage& stage);

  /// Says where everybody is; once, before the first motion.
  void begin(Stage& stage);
  /// Says what has changed by the last motion.
  void follow(Stage& stage);

  [[nodiscard]] const Spot& spot(std::size_t robot) const { return spots_[robot]; }
  [[nodiscard]] const Sites& sites() const { return sites_; }
  void add_to(Digest& digest) const;

 private:
  struct Point {
    WorldVec place_m;
    double reach_m = 0.0;
  };
  void reach_points(Stage& stage);

  Sites sites_;
  std::vector<Point> points_;
  std::vector<Spot> spots_;            ///< Per robot.
  std::vector<std::uint8_t> reached_;  ///< Robot by robot, point by point.
};

}  // namespace tacit
