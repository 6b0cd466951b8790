#pragma once

#include "idl/overlay/plan.h"
#include "wizard_service/cbr/case.h"
#include "wizard_service/cbr/case_index.h"
#include "wizard_service/cbr/proposal.h"
#include "wizard_service/cbr/request.h"
#include "wizard_service/cbr/terrain.h"

namespace tacit::cbr {

/// Retrieve, propose, adapt, criticize: the plans for a request on a map, best first.
///
/// Throws ConfigError when the request has mistakes (a task outside the map among them) or when
/// there is no case for a task of it. Deterministic: the same request, map and cases give the same
/// answer, in whatever order the cases were stored.
[[nodiscard]] Answer answer(const PlanRequest& request, const Terrain& terrain,
                            const CaseIndex& index, CaseSource& cases);

}  // namespace tacit::cbr
