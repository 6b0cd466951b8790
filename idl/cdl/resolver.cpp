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

const Parameter* look_up(const Scope& scope, std::string_view name) {
  for (const Scope* at = &scope; at != nullptr; at = at->around) {
    const Parameter* found = at->offered == nullptr ? nullptr : find_parameter(*at->offered, name);
    if (found != nullptr) {
      return found;
    }
  }
  return nullptr;
}

bool is_sensor(const Device& device) {
  return device.binding.starts_with("sense") || device.type.starts_with("DETECT_") ||
         device.type.starts_with("GET_");
}

}  // namespace

Resolved resolve(const Mission& mission) { return Resolver(mission).run(mission); }

Resolved Resolver::run(const Mission& mission) {
  bool has_team = false;
  for (const Statement& statement : mission.statements) {
    if (statement.kind == Statement::Kind::Configuration) {
      robots(statement.body, 0);
      has_team = true;
    }
  }
  for (const Statement& statement : mission.statements) {
    if (!has_team && statement.body.name == "vehicle") {
      robots(statement.body, 0);
    }
  }
  return std::move(resolved_);
}

void Resolver::robots(const Expression& team, int depth) {
  if (too_much(depth, team.span)) {
    return;
  }
  if (team.kind == Kind::Group) {
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
    const Item* bound = find_slot(team, "bound_to");
    robot(bound == nullptr ? team : bound->value, depth + 1);
  }
}

void Resolver::robot(const Expression& bound, int depth) {
  if (too_much(depth, bound.span)) {
    return;
  }
  if (bound.kind == Kind::Reference) {
    if (const Expression* target = followed(bound)) {
      robot(*target, depth + 1);
    }
    return;
  }
  Robot made;
  made.name = bound.labels.empty() ? bound.name : bound.labels.front();
  made.type = bound.name;
  made.span = bound.span;
  devices(bound, made, depth + 1);
  resolved_.robots.push_back(std::move(made));
}

void Resolver::devices(const Expression& list, Robot& robot, int depth) {
  if (too_much(depth, list.span)) {
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
  const Item* bound_to = find_slot(point, "bound_to");
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
    if (find_parameter(made.parameters, parameter.name) == nullptr) {
      made.parameters.push_back(std::move(parameter));
    }
  }
  const Scope scope{nullptr, &made.parameters};
  made.inputs = members(*bound, "", scope, depth + 1);
  (is_sensor(made) ? robot.sensors : robot.actuators).push_back(std::move(made));
}

std::vector<Parameter> Resolver::parameters(const Expression& list, const Scope& scope) {
  std::vector<Parameter> made;
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
  if (const Parameter* above = look_up(scope, name)) {
    return above->value;
  }
  find(Severity::Warning, "nothing-above", "nothing above gives a value for " + name,
       item.value.span);
  return value;
}

const Expression* Resolver::followed(const Expression& reference) {
  const Statement* statement = names_.find(reference.name);
  const bool made = statement != nullptr && statement->kind == Statement::Kind::Instantiation;
  return made ? &statement->body : nullptr;
}

bool Resolver::too_much(int depth, const Span& span) {
  if (++parts_ > kMostParts) {
    if (parts_ == kMostParts + 1) {
      find(Severity::Error, "too-large", "the team has too many parts, wanted at most a million",
           span);
    }
    return true;
  }
  if (depth > kDeepestReference) {
    find(Severity::Error, "too-deep", "references to references, too deep or in a circle", span);
    return true;
  }
  return false;
}

void Resolver::find(Severity severity, const char* rule, const std::string& text,
                    const Span& span) {
  if (found_.emplace(span.begin, rule).second) {
    resolved_.findings.push_back({severity, rule, text, span.begin, 0, 0});
  }
}

}  // namespace tacit::cdl
