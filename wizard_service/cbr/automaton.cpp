#include "wizard_service/cbr/automaton.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "idl/types/shortest.h"
#include "wizard_service/cbr/plan_cdl.h"

namespace tacit::cbr {

const PlanState* find_state(const RobotPlan& robot, std::string_view name) {
  const auto found = std::find_if(robot.states.begin(), robot.states.end(),
                                  [&](const PlanState& one) { return one.name == name; });
  return found == robot.states.end() ? nullptr : &*found;
}

PlanState* find_state(RobotPlan& robot, std::string_view name) {
  const auto found = std::find_if(robot.states.begin(), robot.states.end(),
                                  [&](const PlanState& one) { return one.name == name; });
  return found == robot.states.end() ? nullptr : &*found;
}

std::string entry_of(const RobotPlan& part) {
  const PlanState* start = find_state(part, kStart);
  const bool waits = start != nullptr && behaviour_name(start->behaviour) == "Stop";
  if (waits && start->rules.size() == 1 &&
      behaviour_name(start->rules.front().trigger) == "Immediate") {
    return start->rules.front().target;
  }
  return std::string(kStart);
}

bool is_end(const PlanState& state) {
  const std::string name = behaviour_name(state.behaviour);
  return name == "Terminate" || name == "TerminateMission" ||
         (name == "Stop" && state.rules.empty());
}

std::vector<const PlanState*> reachable_from(const RobotPlan& robot, std::string_view from) {
  std::set<std::string, std::less<>> seen{std::string(from)};
  std::vector<std::string> open{std::string(from)};
  while (!open.empty()) {
    const PlanState* state = find_state(robot, open.back());
    open.pop_back();
    if (state == nullptr) continue;
    for (const PlanRule& rule : state->rules) {
      if (seen.insert(rule.target).second) open.push_back(rule.target);
    }
  }
  std::vector<const PlanState*> reached;
  for (const PlanState& state : robot.states) {
    if (seen.contains(state.name)) reached.push_back(&state);
  }
  return reached;
}

bool ends_for_all(const PlanState& state) {
  return behaviour_name(state.behaviour) == "TerminateMission";
}

bool ends_by_itself(const RobotPlan& part) {
  const auto reached = reachable_from(part, kStart);
  return std::any_of(reached.begin(), reached.end(),
                     [](const PlanState* one) { return is_end(*one); });
}

bool ends_for_all(const RobotPlan& part) {
  const auto reached = reachable_from(part, kStart);
  return std::any_of(reached.begin(), reached.end(),
                     [](const PlanState* one) { return ends_for_all(*one); });
}

std::string fresh_name(const RobotPlan& robot) {
  for (std::size_t number = robot.states.size();; ++number) {
    std::string name = "$AN_" + std::to_string(number);
    if (find_state(robot, name) == nullptr) return name;
  }
}

std::string told(const PlanState& state) {
  const std::string name = behaviour_name(state.behaviour);
  return state.label.empty() ? name : name + " (" + state.label + ')';
}

std::string number_text(double value) { return shortest(std::round(value * 100.0) / 100.0); }

std::string place_text(double x_m, double y_m) {
  return number_text(x_m) + ", " + number_text(y_m);
}

}  // namespace tacit::cbr
