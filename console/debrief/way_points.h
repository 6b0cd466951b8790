#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>

#include "console/debrief/checklist.h"
#include "console/debrief/team_watch.h"
#include "console/debrief/time_scale.h"
#include "idl/overlay/plan.h"

namespace tacit {

/// Each point of the map whose name begins with Way, Entry or Approach is to be reached by a robot
/// of the team; letters' case does not matter.
class WayPoints {
 public:
  explicit WayPoints(const MapPlan& plan);
  void add(const Event& event, const TeamWatch& team);
  void append_to(Checklist& list, const TimeScale& scale) const;

 private:
  struct Point {
    std::string name;
    std::optional<Deed> reached;
  };
  std::map<std::uint32_t, Point> points_;  ///< By their numbers in the map.
};

}  // namespace tacit
