#include "wizard_service/cbr/watch.h"

#include <algorithm>

#include "wizard_service/cbr/automaton.h"
#include "wizard_service/cbr/plan_cdl.h"

namespace tacit::cbr {
namespace {

/// Empty when nothing is said there.
std::string said_in(const RobotPlan& robot, const std::string& name) {
  const PlanState* state = find_state(robot, name);
  if (state == nullptr || behaviour_name(state->behaviour) != "NotifyRobots") return {};
  const std::string* word = parameter(state->behaviour, "notify_message");
  return word == nullptr ? std::string() : *word;
}

std::string warning_of(const RobotPlan& robot) {
  for (const PlanState& state : robot.states) {
    for (const PlanRule& rule : state.rules) {
      const std::string word = sees_enemies(rule) ? said_in(robot, rule.target) : "";
      if (!word.empty()) return word;
    }
  }
  return {};
}

}  // namespace

bool sees_enemies(const PlanRule& rule) {
  const std::string* objects = parameter(rule.trigger, "Objects");
  return behaviour_name(rule.trigger) == "Detect" && objects != nullptr &&
         objects->find("Enem") != std::string::npos;
}

std::string warning_of(const Plan& team) {
  if (team.robots.size() < 2) return {};
  for (const RobotPlan& robot : team.robots) {
    const std::string word = warning_of(robot);
    if (!word.empty()) return word;
  }
  return {};
}

std::string warned_entry_of(const RobotPlan& part) {
  const std::string entry = entry_of(part);
  const PlanState* state = find_state(part, entry);
  if (state == nullptr) return entry;
  const auto rule = std::find_if(state->rules.begin(), state->rules.end(), sees_enemies);
  return rule == state->rules.end() ? entry : rule->target;
}

}  // namespace tacit::cbr
