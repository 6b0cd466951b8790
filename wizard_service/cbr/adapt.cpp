#include "wizard_service/cbr/adapt.h"

#include <algorithm>
#include <array>

#include "wizard_service/cbr/automaton.h"
#include "wizard_service/cbr/features.h"
#include "wizard_service/cbr/plan_cdl.h"

namespace tacit::cbr {
namespace {

void fit_team(Plan& plan, const Fit& fit, Changes& changes) {
  const std::size_t before = plan.robots.size();
  const auto wanted = static_cast<std::size_t>(fit.robots);
  if (before == wanted) return;
  const std::string last = plan.robots.back().name;
  while (plan.robots.size() < wanted) {
    RobotPlan again = plan.robots[before - 1];
    again.name += std::to_string(plan.robots.size() - before + 2);
    plan.robots.push_back(std::move(again));
  }
  plan.robots.resize(wanted);
  changes.adapt(
      "team-size",
      fit.task + (before < wanted ? " has more robots; " + last + "'s part is played again."
                                  : " has fewer robots; the last ones' parts are left out."),
      std::to_string(before), std::to_string(wanted));
}

constexpr std::string_view kGoal = "Goal_Location";

constexpr std::array<std::string_view, 6> kMoving{"GoTo",   "MoveToward", "MoveTo",
                                                  "Follow", "StayWith",   "MoveAway"};

bool fit_gains(PlanState& state, const AvoidGains& gains) {
  const std::string name = behaviour_name(state.behaviour);
  if (std::find(kMoving.begin(), kMoving.end(), name) == kMoving.end()) return false;
  set_parameter(state.behaviour, "avoid_obstacle_gain", number_text(gains.gain));
  set_parameter(state.behaviour, "avoid_obstacle_sphere", number_text(gains.sphere_m));
  set_parameter(state.behaviour, "avoid_obstacle_safety_margin", number_text(gains.margin_m));
  return true;
}

void fit_environment(Plan& plan, const Case& from, const Fit& fit, Changes& changes) {
  if (from.features.environment == fit.environment) return;
  const AvoidGains gains = usual_gains(fit.environment);
  std::size_t changed = 0;
  for (RobotPlan& robot : plan.robots) {
    for (PlanState& state : robot.states) changed += fit_gains(state, gains) ? 1 : 0;
  }
  if (changed == 0) return;
  changes.adapt("gains",
                fit.task + " is to be done elsewhere than its case: " + std::to_string(changed) +
                    (changed == 1 ? " state avoids" : " states avoid") +
                    " obstacles as is usual there.",
                std::string(word(from.features.environment)),
                std::string(word(fit.environment)) + ": gain " + number_text(gains.gain) +
                    ", sphere " + number_text(gains.sphere_m) + " m");
}

/// Counts the goals that it sets.
std::size_t set_goals(cdl::Expression& expression, std::string_view name, const MapPoint& place) {
  std::size_t set = 0;
  if (const std::string* goal = parameter(expression, kGoal); goal != nullptr && *goal == name) {
    set_parameter(expression, kGoal, place_text(place.x_m, place.y_m));
    ++set;
  }
  for (cdl::Item& item : expression.items) set += set_goals(item.value, name, place);
  return set;
}

void fit_place(Plan& plan, std::string_view name, const MapPoint& place, const Fit& fit,
               Changes& changes) {
  std::size_t set = 0;
  for (cdl::Statement& shared : plan.shared) set += set_goals(shared.body, name, place);
  for (RobotPlan& robot : plan.robots) {
    for (PlanState& state : robot.states) {
      set += set_goals(state.behaviour, name, place);
      for (PlanRule& rule : state.rules) set += set_goals(rule.trigger, name, place);
    }
  }
  if (set == 0) return;
  changes.adapt("place",
                fit.task + " goes to a place that its case calls " + std::string(name) + '.',
                std::string(name), '(' + place_text(place.x_m, place.y_m) + ')');
}

void fit_speeds(Plan& plan, const Fit& fit) {
  for (RobotPlan& robot : plan.robots) {
    robot.max_mps = fit.max_mps;
    robot.base_mps = fit.base_mps;
    robot.cautious_mps = std::min(robot.cautious_mps, fit.base_mps);
  }
}

}  // namespace

AvoidGains usual_gains(Environment environment) {
  return environment == Environment::Indoor ? AvoidGains{0.3, 0.7, 0.3} : AvoidGains{1.0, 2.2, 0.3};
}

Plan adapt(const Case& from, const Fit& fit, Changes& changes) {
  Plan plan = from.plan;
  fit_team(plan, fit, changes);
  fit_environment(plan, from, fit, changes);
  fit_place(plan, kBeginPlace, fit.begin, fit, changes);
  fit_place(plan, kOutsidePlace, fit.outside, fit, changes);
  fit_speeds(plan, fit);
  return plan;
}

}  // namespace tacit::cbr
