#pragma once

#include <functional>
#include <string>

#include "idl/overlay/plan.h"
#include "wizard_service/cbr/case.h"
#include "wizard_service/cbr/case_index.h"
#include "wizard_service/cbr/proposal.h"
#include "wizard_service/cbr/request.h"
#include "wizard_service/cbr/terrain.h"

namespace tacit::cbr {

/// Hears what share of the work is done, 0 to 1, and what is being done.
using Progress = std::function<void(double, const std::string&)>;

/// Retrieve, propose, adapt, criticize: the plans for a request on a map, best first.
///
/// Throws ConfigError when the request has mistakes (a task outside the map among them) or when
/// there is no case for a task of it. Deterministic: the same request, map and cases give the same
/// answer, in whatever order the cases were stored.
[[nodiscard]] Answer answer(const PlanRequest& request, const Terrain& terrain,
                            const CaseIndex& index, CaseSource& cases,
                            const Progress& progress = {});

}  // namespace tacit::cbr
