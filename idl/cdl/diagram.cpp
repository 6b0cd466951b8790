#include "idl/cdl/diagram.h"

#include <array>
#include <charconv>
#include <map>
#include <utility>

#include "idl/cdl/label.h"

namespace tacit::cdl {
namespace {

std::string shown(double number) {
  std::array<char, 32> text{};
  return {text.data(), std::to_chars(text.data(), text.data() + text.size(), number).ptr};
}

std::string shown(const Value& value) {
  struct Text {
    std::string operator()(const NoValue&) const { return ""; }
    std::string operator()(double number) const { return shown(number); }
    std::string operator()(const std::vector<double>& list) const {
      std::string text;
      for (const double number : list) {
        text += (text.empty() ? "" : " ") + shown(number);
      }
      return text;
    }
    std::string operator()(bool flag) const { return flag ? "true" : "false"; }
    std::string operator()(const Words& words) const {
      std::string text;
      for (const std::string& word : words.words) {
        text += (text.empty() ? "" : " or ") + word;
      }
      return text;
    }
    std::string operator()(const QuotedText& quoted) const { return '"' + quoted.text + '"'; }
    std::string operator()(const FromAbove&) const { return "^"; }
  };
  return std::visit(Text{}, value);
}

std::string caption(const Behaviour& behaviour) {
  std::string values;
  for (const Parameter& parameter : behaviour.parameters) {
    values += (values.empty() ? "" : ", ") + shown(parameter.value);
  }
  // What the library has is best known by its name.
  const auto* primitive = std::get_if<Primitive>(&behaviour.form);
  const bool named = primitive != nullptr && primitive->inputs.empty();
  const bool described = !named && !behaviour.description.empty() && behaviour.name != "FSA";
  const std::string name = described ? behaviour.description : behaviour.name;
  return values.empty() ? name : name + '(' + values + ')';
}

/// In a state the name is enough; the numbers would hide the graph.
std::string state_label(const State& state) {
  const std::string what =
      state.behaviour.description.empty() ? state.behaviour.name : state.behaviour.description;
  const std::string label = state.label.empty() ? state.name : state.label;
  return label_of(what.empty() || what == label ? label : label + ": " + what);
}

void fill(Box& box, const Behaviour& behaviour);

void fill(Box& box, const Automaton& automaton) {
  std::map<std::string, std::string> ids;
  for (const State& state : automaton.states) {
    Box inner;
    inner.id = box.id + "_s" + std::to_string(box.inside.size());
    inner.label = state_label(state);
    ids.emplace(state.name, inner.id);
    fill(inner, state.behaviour);
    box.inside.push_back(std::move(inner));
  }
  const auto start = ids.find("Start");
  box.initial = start == ids.end() ? "" : start->second;
  for (std::size_t i = 0; i < automaton.states.size(); ++i) {
    for (const Rule& rule : automaton.states[i].rules) {
      const auto to = ids.find(rule.target);
      if (to != ids.end()) {
        box.arrows.push_back(
            {box.inside[i].id, to->second, rule.trigger.name, label_of(caption(rule.trigger))});
      }
    }
  }
}

void fill(Box& box, const std::vector<Member>& members) {
  box.concurrent = true;
  for (const Member& member : members) {
    Box inner;
    inner.id = box.id + "_m" + std::to_string(box.inside.size());
    const std::string weight = shown(member.weight);
    inner.label = label_of((weight.empty() ? "" : weight + " × ") + caption(member.behaviour));
    fill(inner, member.behaviour);
    box.inside.push_back(std::move(inner));
  }
}

void fill(Box& box, const Behaviour& behaviour) {
  if (const auto* automaton = std::get_if<Automaton>(&behaviour.form)) {
    fill(box, *automaton);
  } else if (const auto* sum = std::get_if<WeightedSum>(&behaviour.form)) {
    fill(box, sum->members);
  } else if (const auto* learner = std::get_if<Learner>(&behaviour.form)) {
    fill(box, learner->actions);
    box.concurrent = false;
  }
}

Box box_of(const Device& device, const std::string& id) {
  Box box;
  box.id = id;
  box.label = label_of(device.name + ": " + device.type);
  if (device.inputs.size() == 1) {
    fill(box, device.inputs.front().behaviour);
  } else {
    fill(box, device.inputs);
  }
  return box;
}

}  // namespace

Box diagram_of(const std::vector<Robot>& robots) {
  Box team;
  team.id = "team";
  team.label = "team";
  team.concurrent = true;
  for (const Robot& robot : robots) {
    Box box;
    box.id = "r" + std::to_string(team.inside.size());
    box.label = label_of(robot.name + " (" + robot.type + ')');
    box.concurrent = true;
    for (const Device& device : robot.actuators) {
      box.inside.push_back(box_of(device, box.id + "_d" + std::to_string(box.inside.size())));
    }
    team.inside.push_back(std::move(box));
  }
  return team;
}

}  // namespace tacit::cdl
