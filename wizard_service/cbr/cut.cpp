#include "wizard_service/cbr/cut.h"

#include <functional>
#include <map>
#include <set>
#include <utility>

#include "wizard_service/cbr/automaton.h"
#include "wizard_service/cbr/join.h"
#include "wizard_service/cbr/plan_cdl.h"

namespace tacit::cbr {
namespace {

/// References that are followed one after another; a circle ends here.
constexpr int kDeepest = 64;

/// Of a rule that leads out of a part, as long as the part's end has no name.
constexpr std::string_view kOut = "?";

bool says_release(const cdl::Expression& expression) {
  const std::string* word = parameter(expression, "notify_message");
  if (word == nullptr || word->size() < 2) return false;
  return is_release_word(std::string_view(*word).substr(1, word->size() - 2));
}

class Cutter {
 public:
  Cutter(const Plan& plan, const RobotPlan& robot) : robot_(robot) {
    for (const cdl::Statement& one : plan.shared) shared_.emplace(one.name, &one.body);
    for (const PlanState& state : robot.states) states_.emplace(state.name, &state);
  }

  [[nodiscard]] std::vector<Cut> cuts() const {
    std::vector<Cut> cuts;
    for (const PlanState* state : come_to(std::string(kStart), &Cutter::as_it_is)) {
      if (begins(*state)) cuts.push_back({state->label, part_after(*state)});
    }
    return cuts;
  }

 private:
  using Look = PlanState (Cutter::*)(const PlanState&) const;

  [[nodiscard]] PlanState as_it_is(const PlanState& state) const { return state; }

  /// A state as the part has it: without what joined it to others.
  [[nodiscard]] PlanState parted(const PlanState& state) const {
    PlanState own = state;
    if (named(own.behaviour) == "NotifyRobots" && says_release(own.behaviour)) {
      own.label = "Done";
      own.behaviour = behaviour("TerminateMission");
      own.rules.clear();
    }
    std::erase_if(own.rules, [&](const PlanRule& rule) {
      return named(rule.trigger) == "Notified" && says_release(rule.trigger);
    });
    for (PlanRule& rule : own.rules) {
      if (leads_out(rule.target)) rule.target = kOut;
    }
    return own;
  }

  /// The states in the order in which they are come to from the one called `from`.
  [[nodiscard]] std::vector<const PlanState*> come_to(const std::string& from, Look look) const {
    std::vector<const PlanState*> order;
    std::set<std::string, std::less<>> seen;
    const auto come = [&](const std::string& name) {
      const auto state = states_.find(name);
      if (state != states_.end() && seen.insert(name).second) order.push_back(state->second);
    };
    come(from);
    for (std::size_t i = 0; i < order.size(); ++i) {
      for (const PlanRule& rule : (this->*look)(*order[i]).rules) come(rule.target);
    }
    return order;
  }

  [[nodiscard]] RobotPlan part_after(const PlanState& beginning) const {
    RobotPlan part = robot_;
    part.states = {{std::string(kStart), "Start", behaviour("Stop"), {}}};
    const std::string first = first_after(beginning);
    if (first != kOut) {
      for (const PlanState* state : come_to(first, &Cutter::parted)) {
        part.states.push_back(parted(*state));
      }
    }
    part.states.front().rules = {{behaviour("Immediate"), first}};
    keep_one_start(part);
    end(part);
    return part;
  }

  [[nodiscard]] std::string first_after(const PlanState& beginning) const {
    std::string first(kOut);
    for (auto rule = beginning.rules.rbegin(); rule != beginning.rules.rend(); ++rule) {
      if (named(rule->trigger) == "SubMissionReady") first = rule->target;
    }
    return leads_out(first) ? std::string(kOut) : first;
  }

  /// A part that goes back to the mission's Start keeps that under another name.
  static void keep_one_start(RobotPlan& part) {
    const auto old = [](const std::string& name) { return name == kStart; };
    const std::string name = fresh_name(part);
    for (std::size_t i = 1; i < part.states.size(); ++i) {
      if (old(part.states[i].name)) part.states[i].name = name;
    }
    for (PlanState& state : part.states) {
      for (PlanRule& rule : state.rules) {
        if (old(rule.target)) rule.target = name;
      }
    }
  }

  static void end(RobotPlan& part) {
    const std::string name = fresh_name(part);
    bool is_needed = false;
    for (PlanState& state : part.states) {
      for (PlanRule& rule : state.rules) {
        if (rule.target != kOut) continue;
        rule.target = name;
        is_needed = true;
      }
    }
    if (is_needed) part.states.push_back({name, "Done", behaviour("Terminate"), {}});
  }

  [[nodiscard]] bool begins(const PlanState& state) const {
    return named(state.behaviour) == "StartSubMission" && !is_on_the_way(state);
  }

  [[nodiscard]] static bool is_on_the_way(const PlanState& state) {
    return state.label.starts_with(kWayLabel);
  }

  [[nodiscard]] bool is_joint(const PlanState& state) const {
    return begins(state) || is_on_the_way(state);
  }

  /// To a joint, or to what only waits to go on to one.
  [[nodiscard]] bool leads_out(const std::string& target) const {
    const auto found = states_.find(target);
    if (found == states_.end()) return target == kOut;
    const PlanState& state = *found->second;
    if (is_joint(state)) return true;
    const bool rests = named(state.behaviour) == "Stop" || is_end(state);
    if (!rests || state.rules.size() != 1 || named(state.rules.front().trigger) != "Immediate") {
      return false;
    }
    const auto next = states_.find(state.rules.front().target);
    return next != states_.end() && is_joint(*next->second);
  }

  /// The name of the behaviour or trigger, shared groups followed.
  [[nodiscard]] std::string named(const cdl::Expression& expression) const {
    std::string name = behaviour_name(expression);
    for (int depth = 0; depth < kDeepest; ++depth) {
      const auto found = shared_.find(name);
      if (found == shared_.end()) break;
      name = behaviour_name(*found->second);
    }
    return name;
  }

  const RobotPlan& robot_;
  std::map<std::string, const cdl::Expression*, std::less<>> shared_;
  std::map<std::string, const PlanState*, std::less<>> states_;
};

}  // namespace

std::vector<Cut> cuts_of(const Plan& plan, const RobotPlan& robot) {
  return Cutter(plan, robot).cuts();
}

}  // namespace tacit::cbr
