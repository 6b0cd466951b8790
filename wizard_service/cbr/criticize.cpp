#include "wizard_service/cbr/criticize.h"

#include <algorithm>
#include <array>
#include <set>
#include <string>

#include "wizard_service/cbr/automaton.h"
#include "wizard_service/cbr/plan_cdl.h"
#include "wizard_service/cbr/watch.h"

namespace tacit::cbr {
namespace {

template <std::size_t N>
bool is_one_of(const std::array<std::string_view, N>& names, std::string_view name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

std::string in(const RobotPlan& robot, const PlanState& state) {
  return told(state) + " of " + robot.name;
}

// ---- words

/// Calls `visit` for every expression, from the top down.
template <class Visit>
void each(const cdl::Expression& expression, const Visit& visit) {
  visit(expression);
  for (const cdl::Item& item : expression.items) each(item.value, visit);
}

/// What NotifyRobots, Notify and ExitTask say anywhere.
std::set<std::string> spoken(const Plan& plan) {
  std::set<std::string> words;
  const auto take = [&](const cdl::Expression& one) {
    const std::string* said = parameter(one, "notify_message");
    const std::string name = behaviour_name(one);
    if (said != nullptr && (name == "NotifyRobots" || name == "Notify")) words.insert(*said);
  };
  for (const cdl::Statement& shared : plan.shared) each(shared.body, take);
  for (const RobotPlan& robot : plan.robots) {
    for (const PlanState& state : robot.states) each(state.behaviour, take);
  }
  return words;
}

void drop_unspoken(Plan& plan, Changes& changes) {
  const std::set<std::string> words = spoken(plan);
  for (RobotPlan& robot : plan.robots) {
    for (PlanState& state : robot.states) {
      std::erase_if(state.rules, [&](const PlanRule& rule) {
        const std::string* wanted = parameter(rule.trigger, "notify_message");
        if (behaviour_name(rule.trigger) != "Notified" || wanted == nullptr ||
            words.contains(*wanted)) {
          return false;
        }
        changes.mend("unspoken-word", in(robot, state) + " waits for a word that no robot says.",
                     "Notified " + *wanted, "no such rule");
        return true;
      });
    }
  }
}

// ---- states

void drop_unreachable(RobotPlan& robot, Changes& changes) {
  const auto reached = reachable_from(robot, kStart);
  std::set<std::string> names;
  for (const PlanState* one : reached) names.insert(one->name);
  std::erase_if(robot.states, [&](const PlanState& one) {
    if (names.contains(one.name)) return false;
    changes.mend("unreachable-state", "No rule leads to " + in(robot, one) + '.', told(one),
                 "left out");
    return true;
  });
}

/// Triggers that may never be true, whatever the robot does.
constexpr std::array<std::string_view, 7> kUncertain{
    "Notified", "Detect", "AtDoorway", "Never", "Proceed", "SkipGoal", "TelopComplete"};
/// Behaviours in which a robot waits for somebody or something; it may take as long as it takes.
constexpr std::array<std::string_view, 9> kWaiting{"Stop",     "Follow", "LookFor",
                                                   "StayWith", "Telop",  "Standby*",
                                                   "Wander",   "Spin",   "WaitForProceed"};

bool comes_by_itself(const PlanRule& rule) {
  return !is_one_of(kUncertain, behaviour_name(rule.trigger));
}

/// Where a robot gives up to: its end, made when it has none.
std::string giving_up(RobotPlan& robot) {
  const auto end = std::find_if(robot.states.begin(), robot.states.end(), [](const PlanState& one) {
    return behaviour_name(one.behaviour) == "Terminate";
  });
  if (end != robot.states.end()) return end->name;
  robot.states.push_back({fresh_name(robot), "GiveUp", behaviour("Terminate"), {}});
  return robot.states.back().name;
}

void turn_about(RobotPlan& robot, std::size_t at, Changes& changes) {
  const std::string name = robot.states[at].name;
  const std::string about = fresh_name(robot);
  robot.states[at].rules.push_back({behaviour("AtEndOfHall", {{"Goal_Tolerance", "0.5"}}), about});
  robot.states.push_back(
      {about, "TurnAbout", behaviour("AboutFace"), {{behaviour("AboutFaceCompleted"), name}}});
  changes.mend("missing-trigger",
               in(robot, robot.states[at]) + " would stand at the hallway's end for good.",
               "no AtEndOfHall", "AtEndOfHall, then AboutFace");
}

void give_up(RobotPlan& robot, std::size_t at, Changes& changes) {
  const std::string before =
      robot.states[at].rules.empty() ? "no rule" : "rules that may never hold";
  const std::string end = giving_up(robot);
  robot.states[at].rules.push_back({behaviour("NoProgress", {{"Delay", "10"}}), end});
  changes.mend("dead-end", in(robot, robot.states[at]) + " might last for good.", before,
               "given up after 10 s without progress");
}

void mend_dead_ends(RobotPlan& robot, Changes& changes) {
  for (std::size_t i = 0; i < robot.states.size(); ++i) {
    const PlanState& state = robot.states[i];
    const std::string name = behaviour_name(state.behaviour);
    if (is_end(state) || std::any_of(state.rules.begin(), state.rules.end(), comes_by_itself)) {
      continue;
    }
    if (name == "ProceedAlongHallway") {
      turn_about(robot, i, changes);
    } else if (state.rules.empty() || !is_one_of(kWaiting, name)) {
      give_up(robot, i, changes);
    }
  }
}

/// A robot that stands still at last has not finished in the eyes of its operator.
void finish_stops(RobotPlan& robot, Changes& changes) {
  for (PlanState& state : robot.states) {
    if (behaviour_name(state.behaviour) != "Stop" || !state.rules.empty()) continue;
    state.behaviour = behaviour("Terminate");
    changes.mend("no-end", in(robot, state) + " never says that it is done.", "Stop", "Terminate");
  }
}

bool has_end(const RobotPlan& robot) {
  const auto reached = reachable_from(robot, kStart);
  return std::any_of(reached.begin(), reached.end(),
                     [](const PlanState* one) { return is_end(*one); });
}

void tell_endless(const Plan& plan, Changes& changes) {
  const bool ended_for_all =
      std::any_of(plan.robots.begin(), plan.robots.end(), [](const RobotPlan& robot) {
        return std::any_of(robot.states.begin(), robot.states.end(), [](const PlanState& one) {
          return behaviour_name(one.behaviour) == "TerminateMission";
        });
      });
  for (const RobotPlan& robot : plan.robots) {
    if (has_end(robot) || ended_for_all) continue;
    changes.warn("no-end",
                 "No rule leads " + robot.name + " to an end; its operator has to stop it.");
  }
}

// ---- speeds

/// The most that a type of robot can do. [ours: what makers give for the ActivMedia Pioneer AT and
/// the AmigoBot]
double limit_of(const std::string& type, double wanted) {
  if (type == "PIONEERAT") return std::min(wanted, 0.7);
  if (type == "AMIGOBOT") return std::min(wanted, 0.75);
  return wanted;
}

void slow_down(RobotPlan& robot, const Worry& worry, Changes& changes) {
  const double most = limit_of(robot.type, worry.max_mps);
  const double before = std::max(robot.max_mps, robot.base_mps);
  if (before <= most) return;
  robot.max_mps = std::min(robot.max_mps, most);
  robot.base_mps = std::min(robot.base_mps, most);
  robot.cautious_mps = std::min(robot.cautious_mps, most);
  changes.mend("too-fast",
               robot.name + " is a " + robot.type + " and cannot or must not go so fast.",
               number_text(before) + " m/s", number_text(most) + " m/s");
}

// ---- cover

bool searches(const Plan& plan, const RobotPlan& robot) {
  bool enters = false;
  std::set<std::string> groups;
  const auto look = [&](const cdl::Expression& one) {
    enters = enters || (one.kind == cdl::Expression::Kind::Reference && one.name == "EnterRoom");
    if (one.kind == cdl::Expression::Kind::Reference) groups.insert(one.name);
  };
  for (const PlanState& state : robot.states) each(state.behaviour, look);
  for (const cdl::Statement& shared : plan.shared) {
    if (groups.contains(shared.name)) each(shared.body, look);
  }
  return enters;
}

bool watches_for_enemies(const RobotPlan& robot) {
  return std::any_of(robot.states.begin(), robot.states.end(), [](const PlanState& state) {
    return std::any_of(state.rules.begin(), state.rules.end(), sees_enemies);
  });
}

void tell_cover(const Plan& plan, Changes& changes) {
  const bool covered = std::any_of(plan.robots.begin(), plan.robots.end(), watches_for_enemies);
  for (const RobotPlan& robot : plan.robots) {
    if (!searches(plan, robot) || (plan.robots.size() > 1 && covered)) continue;
    changes.warn("no-cover",
                 robot.name +
                     " goes into rooms where an enemy is expected, and nobody covers it; "
                     "two robots that look after each other would be safer.");
  }
}

}  // namespace

void criticize(Plan& plan, const Worry& worry, Changes& changes) {
  drop_unspoken(plan, changes);
  for (RobotPlan& robot : plan.robots) {
    drop_unreachable(robot, changes);
    finish_stops(robot, changes);
    mend_dead_ends(robot, changes);
    slow_down(robot, worry, changes);
  }
  tell_endless(plan, changes);
  if (worry.enemy) tell_cover(plan, changes);
}

}  // namespace tacit::cbr
