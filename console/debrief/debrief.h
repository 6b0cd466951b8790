#pragma once

#include <cstddef>
#include <optional>

#include "console/debrief/checklist.h"
#include "console/debrief/cover.h"
#include "console/debrief/mines.h"
#include "console/debrief/search.h"
#include "console/debrief/team_watch.h"
#include "console/debrief/time_scale.h"
#include "console/debrief/warnings.h"
#include "console/debrief/way_points.h"
#include "idl/overlay/plan.h"
#include "idl/types/event.h"

namespace tacit {

/// What became of an operation: a fold over its event log into the list of sub-tasks that its map
/// and its enemies make of it, in the manner of a usability test, which counts how many of them a
/// mission gets done. The parts say what each wants; in the end the mission is to be accomplished.
class Debrief {
 public:
  struct Config {
    std::size_t team = 1;       ///< Robots of the team; those with higher numbers are extras.
    bool hostile = false;       ///< Among the extras is an enemy.
    Doors doors = Doors::Open;  ///< How the map's doors stand.
    double tick_s = 0.1;        ///< Above 0.
  };
  /// `plan` need not live on.
  Debrief(const MapPlan& plan, const Config& config);

  /// The log's next event. One that speaks of what the map does not have counts for nothing.
  void add(const Event& event);
  /// As the log stands; `MissionOver` makes it final.
  [[nodiscard]] Checklist result() const;

 private:
  [[nodiscard]] SubTask ending() const;

  TimeScale scale_;
  TeamWatch team_;
  WayPoints way_points_;
  Search search_;
  MinesToStore mines_;
  std::optional<Cover> cover_;        ///< With somebody to cover and to be covered from.
  std::optional<Warnings> warnings_;  ///< Likewise.
  std::optional<Event> over_;         ///< The event of the mission's end.
};

}  // namespace tacit
