#pragma once

#include <string>
#include <vector>

#include "wizard_service/cbr/plan.h"

namespace tacit::cbr {

/// One robot's part of a sub-mission.
struct Cut {
  std::string label;  ///< Of the state that it began after: "BiohazardTask 2".
  RobotPlan part;
};

/// The parts of one robot of `plan` in the order in which they are come to; none when it has no
/// StartSubMission state.
///
/// A part is what can be come to from a StartSubMission state without passing another joint. Where
/// rules led to the next joint, they lead to a Terminate of the part's own. By what the robots
/// released one another from a piece, the word of `release_word`, they no longer do: who said it
/// ends the mission for all, and who heard it has no end of its own, as before `join`.
[[nodiscard]] std::vector<Cut> cuts_of(const Plan& plan, const RobotPlan& robot);

}  // namespace tacit::cbr
