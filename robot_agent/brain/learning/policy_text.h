#pragma once

#include <optional>
#include <string_view>

#include "robot_agent/brain/learning/policy_table.h"
#include "robot_agent/brain/learning/run_stand.h"

namespace tacit {

/// The inverse of `to_line`; empty for any other text. (`parse_policy` is implemented beside it:
/// here alone JSON is read.)
[[nodiscard]] std::optional<RunStand> parse_stand(std::string_view line);

}  // namespace tacit
