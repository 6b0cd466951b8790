#pragma once

#include <optional>

#include "robot_agent/brain/fsa/automaton_plan.h"
#include "robot_agent/brain/mission/arguments.h"

namespace tacit {

/// The motor schema that a primitive of a weighted sum stands for (NOISE, AVOID_OBSTACLES, MOVE_TO,
/// …); empty when it is not known. Where the mission gives no parameters, the scenario's count.
[[nodiscard]] std::optional<SchemaUse> schema_called(const cdl::Behaviour& behaviour, double gain,
                                                     cdl::Findings& findings,
                                                     const cdl::Span& place);

/// The trigger that a perceptual primitive stands for (IS_AN_OBJECT, IS_AT_GOAL); empty when it is
/// not known.
[[nodiscard]] std::optional<Trigger> percept_called(const cdl::Behaviour& behaviour,
                                                    cdl::Findings& findings,
                                                    const cdl::Span& place);

}  // namespace tacit
