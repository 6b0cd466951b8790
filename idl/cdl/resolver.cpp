#include "idl/cdl/resolver.h"

#include <algorithm>
#include <utility>

namespace tacit::cdl {
namespace {

using Kind = Expression::Kind;

const Parameter* find_parameter(const std::vector<Parameter>& parameters, std::string_view name) {
  for (const Parameter& parameter : parameters) {
    if (parameter.name == name) {
      return &parameter;
    }
  }
  return nullptr;
}

/// Bounded by the depth that `parse` allows.
std::uint64_t items_in(const Expression& expression) {
  std::uint64_t items = expression.items.size();
  for (const Item& item : expression.items) {
    items += items_in(item.value);
  }
  return items;
}

std::uint64_t steps_for(const Mission& mission) {
  constexpr std::uint64_t kStepsOfAnItem = 10;
  std::uint64_t items = 0;
  for (const Statement& statement : mission.statements) {
    items += items_in(statement.body);
  }
  return kMostSteps + kStepsOfAnItem * items;
}

bool is_sensor(const Device& device) {
  return device.binding.starts_with("sense") || device.type.starts_with("DETECT_") ||
         device.type.starts_with("GET_");
}

}  // namespace

Resolved resolve(const Mission& mission) { return Resolver(mission).run(); }

Resolver::Resolver(const Mission& mission)
    : mission_(mission), names_(mission), steps_left_(steps_for(mission)) {}

Resolved Resolver::run() {
  bool has_team = false;
  for (const Statement& statement : mission_.statements) {
    if (statement.kind == Statement::Kind::Configuration) {
      robots(statement.body, 0);
      has_team = true;
    }
  }
  for (const Statement& statement : mission_.statements) {
    if (!has_team && statement.body.name == "vehicle") {
      robots(statement.body, 0);
    }
  }
  return {std::move(robots_), findings_.take()};
}

void Resolver::robots(const Expression& team, int depth) {
  if (too_deep(depth, team.span)) {
    return;
  }
  if (team.kind == Kind::Group && spend(team.items.size(), team.span)) {
    for (const Item& item : team.items) {
      if (!item.slot) {
        robots(item.value, depth + 1);
      }
    }
  } else if (team.kind == Kind::Reference) {
    if (const Expression* target = followed(team)) {
      robots(*target, depth + 1);
    }
  } else if (team.kind == Kind::Instance) {
    const Item* bound = slot_of(team, "bound_to");
    robot(bound == nullptr ? team : bound->value, depth + 1);
  }
}

void Resolver::robot(const Expression& bound, int depth) {
  if (too_deep(depth, bound.span)) {
    return;
  }
  const Expression* inner = bound.kind == Kind::Reference ? followed(bound)
                            : bound.kind == Kind::Group   ? body_of(bound)
                                                          : nullptr;
  if (inner != nullptr) {
    robot(*inner, depth + 1);
  } else if (bound.kind == Kind::Instance) {
    Robot made;
    made.name = bound.labels.empty() ? bound.name : bound.labels.front();
    made.type = bound.name;
    made.span = bound.span;
    devices(bound, made, depth + 1);
    robots_.push_back(std::move(made));
  } else if (bound.kind != Kind::Reference) {
    find(Severity::Error, "no-robot", "nothing that is a robot, wanted name:TYPE(…)", bound.span);
  }
}

void Resolver::devices(const Expression& list, Robot& robot, int depth) {
  if (too_deep(depth, list.span) || !spend(list.items.size(), list.span)) {
    return;
  }
  for (const Item& item : list.items) {
    const Expression* part = &item.value;
    if (part->kind == Kind::Reference) {
      part = followed(*part);
    }
    if (part == nullptr || item.slot) {
      continue;
    }
    if (part->kind == Kind::Group) {
      devices(*part, robot, depth + 1);
    } else if (part->kind == Kind::Instance) {
      device(*part, robot, depth + 1);
    }
  }
}

void Resolver::device(const Expression& point, Robot& robot, int depth) {
  const Item* bound_to = slot_of(point, "bound_to");
  const Expression* bound = bound_to == nullptr ? &point : &bound_to->value;
  if (bound->kind == Kind::Reference) {
    bound = followed(*bound);
  }
  if (bound == nullptr) {
    return;
  }
  Device made;
  made.name = bound->labels.empty() ? bound->name : bound->labels.front();
  made.type = bound->name;
  made.binding = point.name;
  made.parameters = parameters(*bound, {});
  for (Parameter& parameter : parameters(point, {})) {
    // What the binding point says holds unless the device says otherwise.
    if (spend(made.parameters.size(), parameter.span) &&
        find_parameter(made.parameters, parameter.name) == nullptr) {
      made.parameters.push_back(std::move(parameter));
    }
  }
  const Scope scope{nullptr, &made.parameters};
  made.inputs = members(*bound, "", scope, depth + 1);
  (is_sensor(made) ? robot.sensors : robot.actuators).push_back(std::move(made));
}

std::vector<Parameter> Resolver::parameters(const Expression& list, const Scope& scope) {
  std::vector<Parameter> made;
  if (!spend(list.items.size(), list.span)) {
    return made;
  }
  for (const Item& item : list.items) {
    if (item.slot && item.value.kind == Kind::Value && !item.slot->index) {
      made.push_back({item.slot->name, effective(item, scope), item.span});
    }
  }
  return made;
}

Value Resolver::effective(const Item& item, const Scope& scope) {
  const Value value = parse_value(item.value.name);
  const FromAbove* from = std::get_if<FromAbove>(&value);
  if (from == nullptr) {
    return value;
  }
  const std::string& name = from->name.empty() ? item.slot->name : from->name;
  if (const Parameter* above = look_up(scope, name, item.value.span)) {
    return above->value;
  }
  find(Severity::Warning, "nothing-above", "nothing above gives a value for " + name,
       item.value.span);
  return value;
}

const Parameter* Resolver::look_up(const Scope& scope, std::string_view name, const Span& span) {
  for (const Scope* at = &scope; at != nullptr; at = at->around) {
    if (at->offered == nullptr || !spend(at->offered->size() + 1, span)) {
      continue;
    }
    if (const Parameter* found = find_parameter(*at->offered, name)) {
      return found;
    }
  }
  return nullptr;
}

const Item* Resolver::slot_of(const Expression& list, std::string_view name) {
  return spend(list.items.size(), list.span) ? find_slot(list, name) : nullptr;
}

const Expression* Resolver::followed(const Expression& reference) {
  const Expression* at = &reference;
  for (int hops = 0; at->kind == Kind::Reference; ++hops) {
    const Statement* statement = names_.find(at->name);
    if (statement == nullptr || statement->kind != Statement::Kind::Instantiation) {
      break;
    }
    if (too_deep(hops, at->span)) {
      return nullptr;
    }
    at = &statement->body;
  }
  return at == &reference ? nullptr : at;
}

bool Resolver::too_deep(int depth, const Span& span) {
  if (!spend(1, span)) {
    return true;
  }
  if (depth > kDeepestReference) {
    find(Severity::Error, "too-deep", "references to references, too deep or in a circle", span);
    return true;
  }
  return false;
}

bool Resolver::spend(std::size_t steps, const Span& span) {
  if (steps_left_ == 0) {
    return false;
  }
  if (steps >= steps_left_) {
    find(Severity::Error, "too-large",
         "references to references make the team too large, wanted fewer", span);
  }
  steps_left_ -= std::min<std::uint64_t>(steps, steps_left_);
  return steps_left_ > 0;
}

void Resolver::find(Severity severity, const char* rule, const std::string& text,
                    const Span& span) {
  if (found_.size() <= 2 * kMostFindings && found_.emplace(span.begin, rule).second) {
    findings_.add({severity, rule, text, span.begin, 0, 0});
  }
}

}  // namespace tacit::cdl
