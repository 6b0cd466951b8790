#include "wizard_service/cases/cbl.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <string>
#include <utility>

#include "idl/types/config_error.h"
#include "wizard_service/cases/cbl_blocks.h"
#include "wizard_service/cbr/features.h"
#include "wizard_service/cbr/plan_cdl.h"

namespace tacit::cbr {
namespace {

/// Later libraries name them; cases are not found by them.
constexpr std::array<std::string_view, 8> kPassedOver{
    "MaxVelocity", "Aggressiveness", "OverlayName", "MissionTime",
    "WeatherZone", "NoFlyZone",      "NoCommZone",  "RobotType"};

/// What a parameter's value is in CDL: the file has `+` for the blanks of texts and lists.
std::string value_of(std::string_view text) {
  if (text.size() >= 2 && text.front() == '{' && text.back() == '}') {
    text = text.substr(1, text.size() - 2);
  }
  std::string value(text);
  if (value.starts_with('"')) {
    std::replace(value.begin(), value.end(), '+', ' ');
  } else {
    for (std::size_t at = 0; (at = value.find("+|+", at)) != std::string::npos; at += 3) {
      value.replace(at, 3, " | ");
    }
  }
  return value;
}

cdl::Expression expression(const CblCall& call) {
  std::vector<Given> given;
  for (const CblPair& parameter : call.parameters) {
    const bool marked = parameter.name.starts_with('%');
    given.push_back(
        {marked ? parameter.name.substr(1) : parameter.name, value_of(parameter.value)});
  }
  return behaviour(call.name, std::move(given));
}

RobotPlan robot_of(const CblPlan& plan, std::size_t number) {
  RobotPlan robot;
  robot.name = "Robot" + std::to_string(number);
  const bool starts = std::any_of(plan.operators.begin(), plan.operators.end(),
                                  [](const CblOperator& one) { return one.call.index == "Start"; });
  if (!starts) {
    robot.states.push_back({"Start",
                            "Start",
                            behaviour("Stop"),
                            {{behaviour("Immediate"), std::string(plan.operators[0].call.index)}}});
  }
  for (const CblOperator& one : plan.operators) {
    PlanState state{std::string(one.call.index), {}, expression(one.call), {}};
    for (const CblCall& effect : one.effects) {
      state.rules.push_back({expression(effect), std::string(effect.index)});
    }
    robot.states.push_back(std::move(state));
  }
  return robot;
}

class Library {
 public:
  Library(const CblBlocks& blocks, std::string_view name) : blocks_(blocks), name_(name) {}

  std::vector<Case> cases() {
    std::vector<Case> cases;
    for (std::size_t i = 0; i < blocks_.cases.size(); ++i) cases.push_back(plans_of(i));
    std::vector<bool> placed(cases.size(), false);
    for (const CblLeaf& leaf : blocks_.leaves) place(leaf, cases, placed);
    const auto lost = std::find(placed.begin(), placed.end(), false);
    if (lost != placed.end()) {
      const auto index = static_cast<std::size_t>(lost - placed.begin());
      refuse(blocks_.cases[index].line,
             "found case " + std::to_string(index) +
                 " in no leaf of the decision tree, wanted its features");
    }
    return cases;
  }

 private:
  [[noreturn]] void refuse(std::size_t line, const std::string& text) const {
    throw ConfigError(name_ + ':' + std::to_string(line) + ": " + text);
  }

  Case plans_of(std::size_t index) const {
    const CblCase& read = blocks_.cases[index];
    if (read.plans.empty() || read.plans.size() > static_cast<std::size_t>(kMostPlannedRobots)) {
      refuse(read.line, "found a case of " + std::to_string(read.plans.size()) +
                            " plans, wanted 1 to " + std::to_string(kMostPlannedRobots));
    }
    Case one;
    one.origin = name_;
    for (const CblPlan& plan : read.plans) {
      if (plan.operators.empty()) refuse(plan.line, "found a plan without operators");
      one.plan.robots.push_back(robot_of(plan, one.plan.robots.size() + 1));
    }
    refuse_no_mission(one.plan, read.line);
    return one;
  }

  /// What prints to a mission that reads back is one, however odd its names.
  void refuse_no_mission(const Plan& plan, std::size_t line) const {
    std::string complaint = "its names or values cannot be written as a mission";
    try {
      if (plan_of(mission_text(plan), "as a mission") == plan) return;
    } catch (const ConfigError& error) {
      complaint = error.what();
    }
    refuse(line, "found a case that is no mission: " + complaint);
  }

  void place(const CblLeaf& leaf, std::vector<Case>& cases, std::vector<bool>& placed) const {
    for (std::size_t i = 0; i < leaf.indexes.size(); ++i) {
      const std::size_t index = number(leaf.indexes[i], leaf.line, "the number of a case");
      if (index >= cases.size()) {
        refuse(leaf.line, "found case " + std::to_string(index) + " of " +
                              std::to_string(cases.size()) + " that count from 0");
      }
      if (placed[index]) {
        refuse(leaf.line, "found case " + std::to_string(index) + " in a second leaf");
      }
      placed[index] = true;
      Case& one = cases[index];
      one.features = features_of(leaf, one.plan.robots.size());
      one.title = std::string(word(one.features.task)) + ", case " + std::to_string(index) +
                  " of " + name_.substr(name_.rfind('/') + 1);
      if (i < leaf.statuses.size()) judge(one.record, leaf.statuses[i], leaf.line);
    }
  }

  [[nodiscard]] std::size_t number(std::string_view text, std::size_t line,
                                   const char* wanted) const {
    std::size_t value = 0;
    const char* const end = text.data() + text.size();
    const auto [stop, error] = std::from_chars(text.data(), end, value);
    if (error != std::errc() || stop != end) {
      refuse(line, "found \"" + std::string(text) + "\", wanted " + wanted);
    }
    return value;
  }

  void judge(TrackRecord& record, std::string_view text, std::size_t line) const {
    constexpr const char* kWanted = "a status: 0 neutral, 1 positive, 2 negative";
    const std::size_t status = number(text, line, kWanted);
    if (status > 2) refuse(line, "found " + std::to_string(status) + ", wanted " + kWanted);
    if (status == 0) return;
    record.outcomes = 1;
    record.good_milli = status == 1 ? 1000 : 0;
  }

  [[nodiscard]] CaseFeatures features_of(const CblLeaf& leaf, std::size_t robots) const {
    const auto task = std::find_if(leaf.features.begin(), leaf.features.end(),
                                   [](const CblPair& one) { return one.name == "Task"; });
    if (task == leaf.features.end()) refuse(leaf.line, "found no Task on the way to a leaf");
    try {
      CaseFeatures features = usual_features(task_called(task->value));
      features.robots = static_cast<int>(robots);
      for (const CblPair& one : leaf.features) {
        const bool passed =
            std::find(kPassedOver.begin(), kPassedOver.end(), one.name) != kPassedOver.end();
        if (!passed) set_feature(features, one.name, one.value);
      }
      return features;
    } catch (const ConfigError& error) {
      refuse(leaf.line, error.what());
    }
  }

  const CblBlocks& blocks_;
  std::string name_;
};

}  // namespace

std::vector<Case> cases_from_cbl(std::string_view text, std::string_view name) {
  const CblBlocks blocks = cbl_blocks(text, name);
  return Library(blocks, name).cases();
}

}  // namespace tacit::cbr
