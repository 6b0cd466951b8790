#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

#include "wizard_service/cbr/case.h"

namespace tacit::cbr {

/// Bytes of a library; more is refused.
inline constexpr std::size_t kLongestCbl = 64'000'000;
/// Blocks in each other; a decision tree needs four for each feature.
inline constexpr std::size_t kDeepestCbl = 200;
inline constexpr std::size_t kMostCblCases = 20'000;
/// Of one robot's plan.
inline constexpr std::size_t kMostOperators = 2'000;
inline constexpr std::size_t kMostEffects = 20'000;

/// The cases of a library of MissionLab's mission expert (`.cbl`), in the file's order.
///
/// A library is lines: `DATA` blocks, one a case, of `PLAN` blocks, one a robot, of operators with
/// parameters and effects; then the decision tree, whose leaves name cases by their number and say
/// whether they were judged good (1), bad (2) or neither (0). A case has the features on the way to
/// its leaf and the leaf's own; what it does not have is usual for its task, the number of robots
/// is that of its plans. A plan without a state Start gets one that leads to its first operator.
///
/// Passed over: lines and blocks that are not known, preconditions (the effects say the same), and
/// the features that cases are not found by (MaxVelocity, Aggressiveness, OverlayName, …).
///
/// Throws ConfigError with `name` and the line for everything else: a block that does not end where
/// it should, NUL, a case in no leaf or in two, no Task, an unknown value of a feature, a plan that
/// is no mission. Takes time in proportion to the text, whatever the text.
[[nodiscard]] std::vector<Case> cases_from_cbl(std::string_view text, std::string_view name);

}  // namespace tacit::cbr
