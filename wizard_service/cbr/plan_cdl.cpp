#include "wizard_service/cbr/plan_cdl.h"

#include <algorithm>
#include <charconv>
#include <optional>
#include <set>
#include <utility>

#include "idl/cdl/check.h"
#include "idl/cdl/finding.h"
#include "idl/cdl/parse.h"
#include "idl/cdl/print.h"
#include "idl/cdl/value.h"
#include "idl/types/config_error.h"
#include "idl/types/shortest.h"

namespace tacit::cbr {
namespace {

using cdl::Expression;
using cdl::Item;
using cdl::Slot;
using cdl::Statement;
using Kind = Expression::Kind;

/// References that are followed one after another; a circle ends here.
constexpr int kDeepest = 64;

const Statement* definition(const cdl::Mission& mission, std::string_view name) {
  const auto found =
      std::find_if(mission.statements.begin(), mission.statements.end(), [&](const Statement& one) {
        return one.kind == Statement::Kind::Instantiation && one.name == name;
      });
  return found == mission.statements.end() ? nullptr : &*found;
}

/// What an expression stands for, references followed.
const Expression& meant(const cdl::Mission& mission, const Expression& expression) {
  const Expression* at = &expression;
  for (int depth = 0; depth < kDeepest && at->kind == Kind::Reference; ++depth) {
    const Statement* found = definition(mission, at->name);
    if (found == nullptr) break;
    at = &found->body;
  }
  return *at;
}

const Item* item_called(const Expression& expression, std::string_view slot) {
  const auto found =
      std::find_if(expression.items.begin(), expression.items.end(),
                   [&](const Item& item) { return item.slot && item.slot->name == slot; });
  return found == expression.items.end() ? nullptr : &*found;
}

bool is_automaton(const Expression& expression) {
  return expression.kind == Kind::Instance && expression.name == "FSA";
}

/// What drives a robot's wheels: the innermost that an automaton is connected to.
class DriveFinder {
 public:
  explicit DriveFinder(const cdl::Mission& mission) : mission_(mission) {}

  /// Null when there is none.
  const Expression* find(const Expression& from, int depth = 0) {
    if (depth > kDeepest) return nullptr;
    const Expression& here = meant(mission_, from);
    for (const Item& item : here.items) {
      if (is_automaton(meant(mission_, item.value))) {
        automaton_ = &meant(mission_, item.value);
        return &here;
      }
    }
    for (const Item& item : here.items) {
      if (const Expression* found = find(item.value, depth + 1)) return found;
    }
    return nullptr;
  }
  [[nodiscard]] const Expression& automaton() const { return *automaton_; }

 private:
  const cdl::Mission& mission_;
  const Expression* automaton_ = nullptr;
};

double number_in(const Expression& drive, std::string_view slot, double otherwise) {
  const Item* item = item_called(drive, slot);
  if (item == nullptr || item->value.kind != Kind::Value) return otherwise;
  const cdl::Value value = cdl::parse_value(item->value.name);
  const auto* number = std::get_if<double>(&value);
  return number == nullptr ? otherwise : *number;
}

bool flag_in(const Expression& drive, std::string_view slot) {
  const Item* item = item_called(drive, slot);
  if (item == nullptr || item->value.kind != Kind::Value) return false;
  const cdl::Value value = cdl::parse_value(item->value.name);
  const auto* flag = std::get_if<bool>(&value);
  return flag != nullptr && *flag;
}

PlanState& state_called(std::vector<PlanState>& states, const std::string& name) {
  const auto found = std::find_if(states.begin(), states.end(),
                                  [&](const PlanState& one) { return one.name == name; });
  if (found != states.end()) return *found;
  states.push_back({name, {}, {}, {}});
  return states.back();
}

std::vector<PlanState> states_of(const Expression& automaton) {
  std::vector<PlanState> states;
  for (const Item& item : automaton.items) {
    if (!item.slot || !item.slot->index || item.slot->name != "society") continue;
    PlanState& state = state_called(states, *item.slot->index);
    state.label = item.slot->description.value_or("");
    state.behaviour = item.value;
  }
  for (const Item& item : automaton.items) {
    if (!item.slot || !item.slot->index || item.slot->name != "rules") continue;
    if (item.value.kind != Kind::Rule || item.value.items.empty()) continue;
    state_called(states, *item.slot->index)
        .rules.push_back({item.value.items.front().value, item.value.name});
  }
  return states;
}

/// The robots of the team: all that groups in groups hold.
void collect_robots(const cdl::Mission& mission, const Expression& from,
                    std::vector<const Expression*>& robots, int depth = 0) {
  const Expression& here = meant(mission, from);
  if (here.kind != Kind::Group || depth > kDeepest) {
    robots.push_back(&from);
    return;
  }
  for (const Item& item : here.items) collect_robots(mission, item.value, robots, depth + 1);
}

std::vector<const Expression*> robots_of(const cdl::Mission& mission) {
  std::vector<const Expression*> robots;
  for (const Statement& statement : mission.statements) {
    if (statement.kind == Statement::Kind::Configuration) {
      collect_robots(mission, statement.body, robots);
    }
  }
  if (!robots.empty()) return robots;
  for (const Statement& statement : mission.statements) {
    if (statement.kind == Statement::Kind::Instantiation && statement.body.name == "vehicle") {
      robots.push_back(&statement.body);
    }
  }
  return robots;
}

/// "Surveyor" and "PIONEERAT" of `Surveyor:PIONEERAT(…)`.
void name_robot(const cdl::Mission& mission, const Expression& from, RobotPlan& robot) {
  const Expression& vehicle = meant(mission, from);
  const Item* bound = item_called(vehicle, "bound_to");
  const Expression& body = bound == nullptr ? vehicle : meant(mission, bound->value);
  if (!body.labels.empty()) robot.name = body.labels.front();
  if (body.kind == Kind::Instance && !body.name.empty()) robot.type = body.name;
}

/// Every name that an expression refers to.
void collect_names(const Expression& expression, std::set<std::string>& names) {
  if (expression.kind == Kind::Reference) names.insert(expression.name);
  for (const Item& item : expression.items) collect_names(item.value, names);
}

/// The statements that states refer to, and those that these refer to, in the file's order.
std::vector<Statement> shared_of(const cdl::Mission& mission,
                                 const std::vector<RobotPlan>& robots) {
  std::set<std::string> wanted;
  for (const RobotPlan& robot : robots) {
    for (const PlanState& state : robot.states) {
      collect_names(state.behaviour, wanted);
      for (const PlanRule& rule : state.rules) collect_names(rule.trigger, wanted);
    }
  }
  std::size_t before = 0;
  while (wanted.size() != before) {
    before = wanted.size();
    for (const Statement& one : mission.statements) {
      if (wanted.contains(one.name)) collect_names(one.body, wanted);
    }
  }
  std::vector<Statement> shared;
  for (const Statement& one : mission.statements) {
    if (one.kind == Statement::Kind::Instantiation && wanted.contains(one.name)) {
      shared.push_back(one);
      shared.back().comments.clear();
    }
  }
  return shared;
}

RobotPlan robot_plan(const cdl::Mission& mission, const Expression& from, std::string_view name) {
  DriveFinder finder(mission);
  const Expression* drive = finder.find(from);
  RobotPlan robot;
  name_robot(mission, from, robot);
  if (drive == nullptr) {
    throw ConfigError(std::string(name) + ": found a robot" +
                      (robot.name.empty() ? "" : " \"" + robot.name + '"') +
                      " that no automaton drives, wanted an FSA at its wheels");
  }
  robot.states = states_of(finder.automaton());
  const RobotPlan usual;
  robot.max_mps = number_in(*drive, "max_vel", usual.max_mps);
  robot.base_mps = number_in(*drive, "base_vel", usual.base_mps);
  robot.cautious_mps = number_in(*drive, "cautious_vel", usual.cautious_mps);
  robot.cautious = flag_in(*drive, "cautious_mode");
  return robot;
}

// ---- and back

Item connected(std::string name, Expression value) {
  Item item;
  item.slot.emplace();
  item.slot->name = std::move(name);
  item.value = std::move(value);
  return item;
}

Expression value(std::string text) {
  Expression expression;
  expression.kind = Kind::Value;
  expression.name = std::move(text);
  return expression;
}

Expression reference(std::string name) {
  Expression expression;
  expression.kind = Kind::Reference;
  expression.name = std::move(name);
  return expression;
}

Item bare(Expression expression) {
  Item item;
  item.value = std::move(expression);
  return item;
}

/// A list in braces would copy whole automata.
template <class... Items>
std::vector<Item> listed(Items&&... items) {
  std::vector<Item> list;
  list.reserve(sizeof...(items));
  (list.push_back(std::forward<Items>(items)), ...);
  return list;
}

/// Where the editor draws the states: five to a row.
cdl::Place place_of(std::size_t index) {
  constexpr std::size_t kColumns = 5;
  return {60.0 + 220.0 * static_cast<double>(index % kColumns),
          60.0 + 140.0 * static_cast<double>(index / kColumns)};
}

Expression automaton_of(const RobotPlan& robot) {
  Expression automaton;
  automaton.kind = Kind::Instance;
  automaton.name = "FSA";
  automaton.place = cdl::Place{12, 15};
  automaton.description = robot.name;
  std::size_t rules = 0;
  for (const PlanState& state : robot.states) rules += state.rules.size();
  automaton.items.reserve(robot.states.size() + rules);
  for (std::size_t i = 0; i < robot.states.size(); ++i) {
    const PlanState& state = robot.states[i];
    Item item = connected("society", state.behaviour);
    item.slot->index = state.name;
    item.slot->place = place_of(i);
    if (!state.label.empty()) item.slot->description = state.label;
    automaton.items.push_back(std::move(item));
  }
  for (const PlanState& state : robot.states) {
    for (const PlanRule& rule : state.rules) {
      Expression out;
      out.kind = Kind::Rule;
      out.name = rule.target;
      out.items.push_back(bare(rule.trigger));
      Item item = connected("rules", std::move(out));
      item.slot->index = state.name;
      automaton.items.push_back(std::move(item));
    }
  }
  return automaton;
}

Statement instantiation(std::string name, cdl::Place place, Expression body) {
  Statement statement;
  statement.kind = Statement::Kind::Instantiation;
  statement.keyword = "instBP";
  statement.name = std::move(name);
  statement.place = place;
  statement.body = std::move(body);
  return statement;
}

Expression instance(std::string type, std::vector<Item> items) {
  Expression expression;
  expression.kind = Kind::Instance;
  expression.name = std::move(type);
  expression.items = std::move(items);
  return expression;
}

Statement wheels_of(const RobotPlan& robot, const std::string& name) {
  Item automaton = connected("v", automaton_of(robot));
  automaton.slot->place = cdl::Place{12, 15};
  Expression drive =
      instance("DRIVE_W_SPIN",
               listed(std::move(automaton), connected("max_vel", value(shortest(robot.max_mps))),
                      connected("base_vel", value(shortest(robot.base_mps))),
                      connected("cautious_vel", value(shortest(robot.cautious_mps))),
                      connected("cautious_mode", value(robot.cautious ? "true" : "false"))));
  drive.labels = {"base"};
  drive.place = cdl::Place{200, 20};
  drive.description = "wheels";
  Item unconnected = connected("v", {});
  unconnected.slot->place = cdl::Place{0, 0};
  Statement wheels = instantiation(
      name, {200, 20},
      instance("movement",
               listed(std::move(unconnected), connected("bound_to", std::move(drive)))));
  wheels.description = "wheels";
  return wheels;
}

Statement vehicle_of(const RobotPlan& robot, const std::string& name, const std::string& wheels) {
  Expression devices;
  devices.kind = Kind::Group;
  devices.labels = {robot.name};
  devices.items.push_back(bare(reference(wheels)));
  Expression body = instance(robot.type, listed(bare(std::move(devices))));
  body.labels = {robot.name};
  body.place = cdl::Place{0, 0};
  body.description = robot.name;
  return instantiation(name, {0, 0},
                       instance("vehicle", listed(connected("bound_to", std::move(body)))));
}

Expression group(std::vector<Item> items) {
  Expression expression;
  expression.kind = Kind::Group;
  expression.items = std::move(items);
  expression.place = cdl::Place{10, 10};
  return expression;
}

constexpr std::string_view kAnonymous = "$AN_";

/// The first number above those of all anonymous statements and states.
int first_free(const Plan& plan) {
  int highest = 99;
  const auto take = [&](const std::string& name) {
    if (!name.starts_with(kAnonymous)) return;
    int number = 0;
    const char* const end = name.data() + name.size();
    if (std::from_chars(name.data() + kAnonymous.size(), end, number).ptr == end) {
      highest = std::max(highest, number);
    }
  };
  for (const Statement& statement : plan.shared) take(statement.name);
  for (const RobotPlan& robot : plan.robots) {
    for (const PlanState& state : robot.states) take(state.name);
  }
  return highest + 1;
}

}  // namespace

Plan plan_of(std::string_view mission, std::string_view name) {
  cdl::refuse_errors(cdl::check_text(mission), mission, name);
  const cdl::Mission read = cdl::parse(mission).mission;
  Plan plan;
  for (const Expression* robot : robots_of(read)) {
    plan.robots.push_back(robot_plan(read, *robot, name));
    RobotPlan& last = plan.robots.back();
    if (last.name.empty()) last.name = "Robot" + std::to_string(plan.robots.size());
  }
  if (plan.robots.empty()) {
    throw ConfigError(std::string(name) + ": found no robot, wanted a team of at least one");
  }
  plan.shared = shared_of(read, plan.robots);
  return plan;
}

cdl::Mission mission_of(const Plan& plan) {
  cdl::Mission mission;
  Statement architecture;
  architecture.kind = Statement::Kind::BindArchitecture;
  architecture.keyword = "bindArch";
  architecture.name = "AuRA.urban";
  mission.statements.push_back(std::move(architecture));
  mission.statements.insert(mission.statements.end(), plan.shared.begin(), plan.shared.end());
  int number = first_free(plan);
  std::vector<Item> team;
  for (const RobotPlan& robot : plan.robots) {
    const std::string wheels = std::string(kAnonymous) + std::to_string(number++);
    const std::string vehicle = std::string(kAnonymous) + std::to_string(number++);
    mission.statements.push_back(wheels_of(robot, wheels));
    mission.statements.push_back(vehicle_of(robot, vehicle, wheels));
    team.push_back(bare(reference(vehicle)));
  }
  Expression inner = group(std::move(team));
  inner.description = "team";
  Statement configuration;
  configuration.kind = Statement::Kind::Configuration;
  configuration.body = group({bare(std::move(inner))});
  mission.statements.push_back(std::move(configuration));
  return mission;
}

std::string mission_text(const Plan& plan, std::string_view comment) {
  cdl::Mission mission = mission_of(plan);
  if (!comment.empty()) {
    mission.statements.front().comments.push_back("/* " + std::string(comment) + " */");
  }
  return cdl::print(mission);
}

std::string behaviour_name(const Expression& expression) {
  if (expression.kind == Kind::Reference || expression.kind == Kind::Instance) {
    return expression.name;
  }
  if (expression.kind != Kind::Group) return {};
  for (auto item = expression.items.rbegin(); item != expression.items.rend(); ++item) {
    if (!item->slot) return behaviour_name(item->value);
  }
  return {};
}

const std::string* parameter(const Expression& expression, std::string_view name) {
  const Item* item = item_called(expression, name);
  return item == nullptr || item->value.kind != Kind::Value ? nullptr : &item->value.name;
}

void set_parameter(Expression& expression, std::string_view name, std::string_view given) {
  for (Item& item : expression.items) {
    if (item.slot && item.slot->name == name) {
      item.value = value(std::string(given));
      return;
    }
  }
  Item item = connected(std::string(name), value(std::string(given)));
  item.slot->is_parameter = true;
  expression.items.insert(expression.items.begin(), std::move(item));
}

Expression behaviour(std::string_view name, std::vector<Given> parameters) {
  std::vector<Item> items;
  items.reserve(parameters.size() + 1);
  for (Given& given : parameters) {
    Item item = connected(std::string(given.name), value(std::move(given.value)));
    item.slot->is_parameter = true;
    items.push_back(std::move(item));
  }
  items.push_back(bare(reference(std::string(name))));
  return group(std::move(items));
}

}  // namespace tacit::cbr
