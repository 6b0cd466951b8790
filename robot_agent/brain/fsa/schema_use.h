#pragma once

#include <memory>
#include <string>

#include "robot_agent/brain/fsa/automaton_plan.h"
#include "robot_agent/brain/schemas/registry.h"

namespace tacit {

/// The schema that `use` names. Throws ConfigError when there is none of that name, when it lacks
/// the thing it is to be about, or when its own parameters cannot be.
[[nodiscard]] std::unique_ptr<Schema> make_schema(const SchemaUse& use,
                                                  const SchemaConfigs& configs, const Self& self);

/// Its name with what it is about: "MoveToMine".
[[nodiscard]] std::string name(const SchemaUse& use);

}  // namespace tacit
