#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "robot_agent/brain/fsa/automaton_plan.h"

namespace tacit {

/// How a robot's wheels turn a weighted sum into speed; empty where the mission says nothing.
struct Wheels {
  std::optional<double> base_mps;
  std::optional<double> max_mps;
  std::optional<double> cautious_mps;
  bool cautious = false;  ///< Slow down to `cautious_mps` inside a safety margin.
};

/// What one robot of a mission is to do.
struct RobotPlan {
  std::string name;
  StatePlan root;  ///< What drives its wheels, mostly an automaton.
  Wheels wheels;
};

/// The robots of a mission in the Configuration Description Language, in the file's order.
///
/// Throws ConfigError, which names every place as "name:line:column: ...", when the text is not a
/// mission, when it has no robots, or when a behaviour, trigger or parameter in it is not known or
/// cannot be. States that no rule leads to are left out.
[[nodiscard]] std::vector<RobotPlan> compile_mission(std::string_view text, std::string_view name);

}  // namespace tacit
