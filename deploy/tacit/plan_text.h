#pragma once

#include <string>

#include "idl/types/plan_answer.h"
#include "idl/types/plan_request.h"

namespace tacit {

/// "★★★★☆ 4.2"
[[nodiscard]] std::string stars_text(double stars);

/// The plans for people, best first; with `explain` also what each case matched and each change
/// with its reason. Without the last newline.
[[nodiscard]] std::string answer_text(const PlanRequest& request, const PlanAnswer& answer,
                                      bool explain);

}  // namespace tacit
