#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "idl/types/plan_answer.h"
#include "idl/types/plan_request.h"

namespace tacit {

/// One object with `plans` and `notes`, indented. Bytes that are no UTF-8 are replaced.
[[nodiscard]] std::string to_json(const PlanAnswer& answer);

/// A request as people's programs write it: `tasks`, a list of objects with `task` ("biohazard",
/// "eod", …), `x` and `y` in the map's frame and perhaps `localization` ("maps", "landmarks"),
/// `environment` ("indoor", "outdoor") and `handles_enemy`; `robots`, `enemy`, `max_velocity_mps`,
/// `aggressiveness`, `top` and `naive`, which may be left out. Throws ConfigError with what was
/// found and what was wanted, keys that nobody knows included; what no plan can be made for is for
/// the wizard to say.
[[nodiscard]] PlanRequest plan_request_from_json(std::string_view json);

/// Features of sub-missions in order: a list of objects with `task`, `robots`, `localization`,
/// `environment` and `handles_enemy`; what is left out is usual for the task. Throws as the other.
[[nodiscard]] std::vector<CaseFeatures> case_features_from_json(std::string_view json);

}  // namespace tacit
