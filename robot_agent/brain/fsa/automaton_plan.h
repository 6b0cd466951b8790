#pragma once

#include <optional>
#include <string>
#include <vector>

#include "idl/types/command.h"
#include "robot_agent/brain/perception/thing.h"
#include "robot_agent/brain/triggers/registry.h"

namespace tacit {

/// A motor schema at work: which, how strongly, and on what, where it is about a class of things.
struct SchemaUse {
  std::string schema;  ///< As it is registered: "MoveTo", …
  double gain = 1.0;
  std::optional<Thing> thing;
};

/// What a robot does in one state: a weighted sum of schemas, and an act beside it.
struct ActivityPlan {
  std::vector<SchemaUse> schemas;
  Act act = Act::None;
};

/// "If trigger goto next."
struct Rule {
  Trigger trigger;
  std::string next;  ///< A state of the same automaton.
};

struct StatePlan {
  std::string name;
  ActivityPlan activity;
  std::vector<Rule> rules;  ///< The first that fires wins.
};

/// An automaton as a table, in code or out of a mission file. The first state is the initial one.
struct AutomatonPlan {
  std::string name;
  std::vector<StatePlan> states;
};

}  // namespace tacit
