#pragma once

#include <vector>

#include "idl/types/plan_request.h"
#include "wizard_service/cbr/features.h"

namespace tacit::cbr {

/// Throws ConfigError that tells every mistake, one a line, when no plan can be meant: no task or
/// too many, a number out of its range.
void refuse_mistakes(const PlanRequest& request);

/// What cases for a task of `request` are looked for by.
[[nodiscard]] Query query_for(const PlanRequest& request, const PlacedTask& task);

/// What the sub-missions of a plan for `request` are found by, task by task.
[[nodiscard]] std::vector<CaseFeatures> features_for(const PlanRequest& request);

}  // namespace tacit::cbr
