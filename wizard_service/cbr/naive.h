#pragma once

#include "idl/types/plan_request.h"
#include "wizard_service/cbr/plan.h"

namespace tacit::cbr {

/// What a person without the wizard draws first: every robot goes to each task in a straight line,
/// one after another, and stops. The counterpart of the usability study's other group.
[[nodiscard]] Plan naive_plan(const PlanRequest& request);

}  // namespace tacit::cbr
