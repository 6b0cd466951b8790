#pragma once

#include "robot_agent/brain/brain_config.h"

namespace tacit {

/// The foraging part of `brain_defaults`, `describe` and `check`.
[[nodiscard]] BrainConfig forage_defaults();
void describe_forage(BrainConfig& config, ParameterVisitor& visitor);
void check_forage(const BrainConfig& config);

}  // namespace tacit
