#pragma once

#include <cstdint>
#include <vector>

#include "idl/cdl/finding.h"
#include "idl/cdl/team.h"

namespace tacit::cdl {

/// References and parameters deeper than this in each other are not followed.
inline constexpr int kDeepestReference = 400;
/// Steps that following may take beside some for each item of the file: a file whose references
/// fan out again and again makes no team larger than this.
inline constexpr std::uint64_t kMostSteps = 1'000'000;

struct Resolved {
  std::vector<Robot> robots;  ///< In the team's order.
  Findings findings;          ///< Not yet located.
};

/// Follows every reference from the team down to behaviours. What cannot be followed is left out
/// or, for a parameter that nothing above gives, stays FromAbove; the findings say so.
///
/// The team is the statement without keyword; without one, every statement made from `vehicle` is
/// a robot.
[[nodiscard]] Resolved resolve(const Mission& mission);

}  // namespace tacit::cdl
