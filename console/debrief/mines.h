#pragma once

#include <cstdint>
#include <map>
#include <optional>

#include "console/debrief/checklist.h"
#include "console/debrief/team_watch.h"
#include "console/debrief/time_scale.h"
#include "idl/overlay/plan.h"

namespace tacit {

/// Each mine, a movable orange object, is to be put into a container by the team.
class MinesToStore {
 public:
  explicit MinesToStore(const MapPlan& plan);
  void add(const Event& event, const TeamWatch& team);
  void append_to(Checklist& list, const TimeScale& scale) const;

 private:
  std::map<std::uint32_t, std::optional<Deed>> stored_;  ///< By object.
};

}  // namespace tacit
