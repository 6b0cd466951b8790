#pragma once

#include <optional>
#include <string>
#include <vector>

#include "robot_agent/brain/mission/arguments.h"
#include "robot_agent/brain/triggers/registry.h"

namespace tacit {

/// The trigger that a mission names, with its parameters; empty when it is not known.
[[nodiscard]] std::optional<Trigger> trigger_called(const Arguments& given);
/// All that are known.
[[nodiscard]] std::vector<std::string> triggers_known();

}  // namespace tacit
