#pragma once

#include <span>
#include <string>

#include "console/report/table.h"
#include "deploy/experiment/wizard_study.h"

namespace tacit {

/// Sub-tasks that a good plan gets done, as a share of all.
inline constexpr double kGoodScore = 0.9;

/// A row for each number of robots and planner: flights, mean score, the share of flights with at
/// least kGoodScore, the share of full checklists, the median time in s; with 95 % intervals.
[[nodiscard]] Table study_table(std::span<const StudyFlight> flights);

/// A row for each flight whose checklist is not full: site, score and the sub-tasks that are
/// missing. Those of the naive plans, which hardly ever do all, are left out.
[[nodiscard]] Table study_failures(std::span<const StudyFlight> flights);

/// A row for each flight, made by this version, with the sub-tasks that are missing and why.
[[nodiscard]] Table study_flights_table(std::span<const StudyFlight> flights,
                                        const std::string& version);

}  // namespace tacit
