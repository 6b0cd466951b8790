#include "robot_agent/brain/mission/compiler.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include "idl/types/nearest_word.h"
#include "robot_agent/brain/mission/primitives.h"
#include "robot_agent/brain/mission/triggers.h"

namespace tacit {
namespace {

const cdl::Device* wheels_of(const cdl::Robot& robot) {
  const auto moves = [](const cdl::Device& device) {
    return device.binding == "movement" || device.type.starts_with("DRIVE");
  };
  const auto found = std::find_if(robot.actuators.begin(), robot.actuators.end(), moves);
  return found == robot.actuators.end() ? nullptr : &*found;
}

/// The states that rules lead to, the first one first; MissionLab begins in `Start`.
std::vector<const cdl::State*> reachable(const cdl::Automaton& automaton) {
  const auto called = [&automaton](std::string_view name) {
    const auto found = std::find_if(automaton.states.begin(), automaton.states.end(),
                                    [name](const cdl::State& state) { return state.name == name; });
    return found == automaton.states.end() ? nullptr : &*found;
  };
  const cdl::State* start = called("Start");
  if (start == nullptr && !automaton.states.empty()) start = &automaton.states.front();
  std::vector<const cdl::State*> reached;
  std::set<std::string_view> seen;
  const auto reach = [&](const cdl::State* state) {
    if (state != nullptr && seen.insert(state->name).second) reached.push_back(state);
  };
  reach(start);
  for (std::size_t i = 0; i < reached.size(); ++i) {
    for (const cdl::Rule& rule : reached[i]->rules) reach(called(rule.target));
  }
  return reached;
}

/// What people call a state: the editor's label, made unique by its name where several share one.
std::string name_of(const cdl::State& state, const std::vector<const cdl::State*>& all) {
  if (state.label.empty()) return state.name;
  const auto same = std::count_if(all.begin(), all.end(), [&state](const cdl::State* each) {
    return each->label == state.label;
  });
  return same == 1 ? state.label : state.label + " " + state.name;
}

std::string label_of(const cdl::Member& member, std::size_t number) {
  if (!member.behaviour.description.empty()) return member.behaviour.description;
  return member.behaviour.name.empty() ? "Action" + std::to_string(number) : member.behaviour.name;
}

}  // namespace

void MissionCompiler::refuse(const char* rule, const std::string& what, const cdl::Span& place) {
  findings_.push_back({cdl::Severity::Error, rule, what, place.begin, 0, 0});
}

RobotPlan MissionCompiler::robot(const cdl::Robot& robot, const TeamPlace& place) {
  place_ = place;
  RobotPlan plan;
  plan.name = robot.name;
  const cdl::Device* device = wheels_of(robot);
  if (device == nullptr || device->inputs.empty()) {
    refuse("wheels", "robot " + robot.name + " has nothing that drives its wheels", robot.span);
    return plan;
  }
  plan.wheels = wheels(*device, robot.span);
  plan.root = content(device->inputs.front().behaviour, robot.span);
  plan.root.name = "Mission";
  return plan;
}

Wheels MissionCompiler::wheels(const cdl::Device& device, const cdl::Span& place) {
  Wheels wheels;
  const auto speed = [&](const cdl::Parameter& parameter) -> std::optional<double> {
    const double* number = std::get_if<double>(&parameter.value);
    if (number != nullptr && *number >= 0.0 && *number <= 100.0) return *number;
    refuse("parameter",
           "%" + parameter.name + " is " + cdl::describe(parameter.value) +
               ", wanted a speed from 0 to 100 m/s",
           place);
    return std::nullopt;
  };
  for (const cdl::Parameter& each : device.parameters) {
    if (each.name == "base_vel") wheels.base_mps = speed(each);
    if (each.name == "max_vel") wheels.max_mps = speed(each);
    if (each.name == "cautious_vel") wheels.cautious_mps = speed(each);
    if (each.name == "cautious_mode") {
      const bool* on = std::get_if<bool>(&each.value);
      wheels.cautious = on != nullptr && *on;
    }
  }
  return wheels;
}

StatePlan MissionCompiler::content(const cdl::Behaviour& behaviour, const cdl::Span& place) {
  if (std::holds_alternative<cdl::Automaton>(behaviour.form)) return automaton(behaviour, place);
  if (std::holds_alternative<cdl::WeightedSum>(behaviour.form)) {
    return weighted_sum(behaviour, place);
  }
  if (std::holds_alternative<cdl::Learner>(behaviour.form)) return learner(behaviour, place);
  if (const BehaviourMaker make = behaviour_called(behaviour.name)) {
    return make(Arguments(behaviour, cdl::Use::Behaviour, place, findings_), place_);
  }
  if (const auto schema = schema_called(behaviour, 1.0, findings_, place)) {
    StatePlan state;
    state.activity.schemas = {*schema};
    return state;
  }
  const std::vector<std::string> known = behaviours_known();
  refuse("unknown-behaviour",
         "behaviour " + behaviour.name + " is not one that Tacit runs" +
             did_you_mean(behaviour.name, known),
         place);
  return {};
}

StatePlan MissionCompiler::automaton(const cdl::Behaviour& behaviour, const cdl::Span& place) {
  const auto states = reachable(std::get<cdl::Automaton>(behaviour.form));
  if (states.empty()) {
    refuse("empty", "an automaton has no states", place);
    return {};
  }
  AutomatonPlan plan;
  plan.name = behaviour.description.empty() ? "FSA" : behaviour.description;
  for (const cdl::State* state : states) {
    StatePlan made = content(state->behaviour, state->span);
    made.name = name_of(*state, states);
    for (const cdl::Rule& rule : state->rules) {
      const auto next = std::find_if(states.begin(), states.end(), [&rule](const cdl::State* each) {
        return each->name == rule.target;
      });
      if (next == states.end()) {
        refuse("undefined-state", "a rule leads to " + rule.target + ", which is no state",
               rule.span);
        continue;
      }
      made.rules.push_back({trigger(rule.trigger, rule.span), name_of(**next, states)});
    }
    plan.states.push_back(std::move(made));
  }
  StatePlan state;
  state.nested = std::make_shared<const AutomatonPlan>(std::move(plan));
  return state;
}

StatePlan MissionCompiler::weighted_sum(const cdl::Behaviour& behaviour, const cdl::Span& place) {
  StatePlan state;
  for (const cdl::Member& member : std::get<cdl::WeightedSum>(behaviour.form).members) {
    const double* weight = std::get_if<double>(&member.weight);
    if (weight == nullptr) {
      refuse("weight",
             "the weight of " + member.behaviour.name + " is " + cdl::describe(member.weight) +
                 ", wanted a number",
             place);
      continue;
    }
    const auto schema = schema_called(member.behaviour, *weight, findings_, place);
    if (!schema) {
      refuse("unknown-behaviour",
             "primitive " + member.behaviour.name + " is not one that Tacit runs", place);
      continue;
    }
    state.activity.schemas.push_back(*schema);
  }
  state.activity.deed = deed(behaviour, place);
  return state;
}

// Tacit's own parameter: what the robot does beside moving.
Deed MissionCompiler::deed(const cdl::Behaviour& behaviour, const cdl::Span& place) {
  struct ActWord {
    std::string_view word;
    Act act;
  };
  constexpr std::array kActs{ActWord{"None", Act::None}, ActWord{"PickUp", Act::PickUp},
                             ActWord{"Drop", Act::Drop}, ActWord{"Intercept", Act::Intercept},
                             ActWord{"Aid", Act::Aid}};
  const Arguments given(behaviour, cdl::Use::Behaviour, place, findings_);
  if (!given.has("act")) return {};
  const std::string word = given.word("act");
  const auto* found = std::find_if(kActs.begin(), kActs.end(),
                                   [&word](const ActWord& each) { return each.word == word; });
  if (found != kActs.end()) return {.act = found->act};
  given.refuse("%act is " + word + ", wanted None, PickUp, Drop, Intercept or Aid");
  return {};
}

Trigger MissionCompiler::trigger(const cdl::Behaviour& behaviour, const cdl::Span& place) {
  const Arguments given(behaviour, cdl::Use::Trigger, place, findings_);
  if (auto made = trigger_called(given)) return *made;
  if (auto made = percept_called(behaviour, findings_, place)) return *made;
  const std::vector<std::string> known = triggers_known();
  refuse("unknown-trigger",
         "trigger " + behaviour.name + " is not one that Tacit knows" +
             did_you_mean(behaviour.name, known),
         place);
  return Never{};
}

StatePlan MissionCompiler::learner(const cdl::Behaviour& behaviour, const cdl::Span& place) {
  const auto& form = std::get<cdl::Learner>(behaviour.form);
  const Arguments given(behaviour, cdl::Use::Behaviour, place, findings_);
  ChoicePlan plan;
  plan.name = given.has("QfileName") ? std::string(given.text("QfileName").text()) : "QLEARN";
  for (std::size_t i = 0; i < form.actions.size(); ++i) {
    StatePlan action = content(form.actions[i].behaviour, place);
    action.name = label_of(form.actions[i], i);
    plan.actions.push_back(std::move(action));
  }
  for (const cdl::Member& member : form.triggers) {
    plan.triggers.push_back(trigger(member.behaviour, place));
  }
  for (const cdl::Reinforcer& each : form.reinforcers) {
    constexpr double kAny = -1000.0;  // MissionLab's
    const auto index = [](double value) -> std::optional<std::size_t> {
      return value == kAny ? std::nullopt : std::optional(static_cast<std::size_t>(value));
    };
    const auto sound = [](double value) {
      return value == kAny || (value >= 0.0 && value < 1e6 && value == std::floor(value));
    };
    if (each.size() != 3 || !sound(each[0]) || !sound(each[1])) {
      refuse("reinforcer", "a reinforcer is not {state, action, reward}", place);
      continue;
    }
    plan.reinforcers.push_back({index(each[0]), index(each[1]), each[2]});
  }
  const auto rate = [&](std::string_view name, double& value) {
    if (!given.has(name)) return;
    value = given.number(name);
    if (!(value >= 0.0 && value <= 1.0))
      given.refuse("%" + std::string(name) + " is not in 0 to 1");
  };
  rate("alpha", plan.learner.alpha);
  rate("alphaDecay", plan.learner.alpha_decay);
  rate("random", plan.learner.epsilon);
  rate("randomDecay", plan.learner.epsilon_decay);
  if (given.has("ActionTimeout")) {
    plan.action_timeout = static_cast<Tick>(std::clamp(given.number("ActionTimeout"), 1.0, 1e9));
  }
  StatePlan state;
  state.choice = std::make_shared<const ChoicePlan>(std::move(plan));
  return state;
}

}  // namespace tacit
