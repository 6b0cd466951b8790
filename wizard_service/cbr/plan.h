#pragma once

#include <string>
#include <vector>

#include "idl/cdl/model.h"

namespace tacit::cbr {

/// A way out of a state: `if trigger goto target`.
struct PlanRule {
  cdl::Expression trigger;  ///< With its parameters: `[%Delay = {2.0}, Wait]`.
  std::string target;       ///< Name of a state of the same part.
  friend bool operator==(const PlanRule&, const PlanRule&) = default;
};

/// What a robot does until one of the rules is true.
struct PlanState {
  std::string name;   ///< `Start`, `$AN_12`; unique in its part.
  std::string label;  ///< What an editor shows; may be empty.
  cdl::Expression behaviour;
  std::vector<PlanRule> rules;
  friend bool operator==(const PlanState&, const PlanState&) = default;
};

/// One robot's automaton, and how fast the robot may go.
struct RobotPlan {
  std::string name;  ///< "Surveyor".
  std::string type = "PIONEERAT";
  std::vector<PlanState> states;  ///< One of them is called Start.
  double max_mps = 0.5;
  double base_mps = 0.2;  ///< Of a motion vector of length 1.
  double cautious_mps = 0.1;
  bool cautious = false;
  friend bool operator==(const RobotPlan&, const RobotPlan&) = default;
};

/// A mission in the form in which it is retrieved, joined, mended and split: flat automata of
/// states, one a robot.
struct Plan {
  std::vector<cdl::Statement> shared;  ///< Groups (`instGroup`) that states refer to by name.
  std::vector<RobotPlan> robots;
  friend bool operator==(const Plan&, const Plan&) = default;
};

}  // namespace tacit::cbr
