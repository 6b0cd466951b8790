#include <map>
#include <utility>

#include "idl/cdl/resolver.h"

namespace tacit::cdl {
namespace {

using Kind = Expression::Kind;

/// The first part of each name.
template <typename Part, typename NameOf>
std::map<std::string, Part*> by_name(std::vector<Part>& parts, NameOf name_of) {
  std::map<std::string, Part*> index;
  for (Part& part : parts) {
    index.emplace(name_of(part), &part);
  }
  return index;
}

}  // namespace

Behaviour Resolver::behaviour(const Expression& expression, const Scope& scope, int depth) {
  if (too_deep(depth, expression.span)) {
    return {};
  }
  switch (expression.kind) {
    case Kind::Group:
      return of_group(expression, scope, depth + 1);
    case Kind::Reference:
      return of_reference(expression, scope, depth + 1);
    case Kind::Instance:
      return of_instance(expression, scope, depth + 1);
    case Kind::Nothing:
    case Kind::Value:
    case Kind::Rule:
      break;
  }
  return {};
}

Behaviour Resolver::of_group(const Expression& group, const Scope& scope, int depth) {
  const std::vector<Parameter> offered = parameters(group, scope);
  const Expression* body = spend(group.items.size(), group.span) ? body_of(group) : nullptr;
  Behaviour made;
  if (body != nullptr) {
    made = behaviour(*body, {&scope, &offered}, depth);
  }
  if (group.description) {
    made.description = *group.description;
  }
  return made;
}

Behaviour Resolver::of_reference(const Expression& reference, const Scope& scope, int depth) {
  if (const Expression* target = followed(reference)) {
    const Item* bound = target->kind == Kind::Instance ? slot_of(*target, "bound_to") : nullptr;
    return behaviour(bound == nullptr ? *target : bound->value, scope, depth);
  }
  Behaviour made;
  made.name = reference.name;
  if (scope.offered != nullptr && spend(scope.offered->size(), reference.span)) {
    made.parameters = *scope.offered;
  }
  return made;
}

Behaviour Resolver::of_instance(const Expression& instance, const Scope& scope, int depth) {
  Behaviour made;
  made.name = instance.name;
  made.description = instance.description.value_or("");
  made.parameters = parameters(instance, scope);
  const Scope inner{&scope, &made.parameters};
  if (instance.name == "FSA") {
    made.form = automaton(instance, inner, depth);
  } else if (instance.name == "COOP") {
    made.form = weighted_sum(instance, inner, depth);
  } else if (instance.name == "QLEARN") {
    made.form = learner(instance, inner, depth);
  } else {
    made.form = Primitive{members(instance, "", inner, depth)};
  }
  return made;
}

Automaton Resolver::automaton(const Expression& instance, const Scope& scope, int depth) {
  Automaton made;
  if (!spend(2 * instance.items.size(), instance.span)) {
    return made;
  }
  for (const Item& item : instance.items) {
    if (item.slot && item.slot->name == "society" && item.slot->index) {
      State state;
      state.name = *item.slot->index;
      state.label = item.slot->description.value_or("");
      state.place = item.slot->place;
      state.span = item.span;
      state.behaviour = behaviour(item.value, scope, depth);
      made.states.push_back(std::move(state));
    }
  }
  const auto states = by_name(made.states, [](const State& state) { return state.name; });
  for (const Item& item : instance.items) {
    const bool is_rule = item.slot && item.slot->name == "rules" && item.slot->index &&
                         item.value.kind == Kind::Rule && !item.value.items.empty();
    const auto state = is_rule ? states.find(*item.slot->index) : states.end();
    if (state != states.end()) {
      Behaviour trigger = behaviour(item.value.items.front().value, scope, depth);
      state->second->rules.push_back({std::move(trigger), item.value.name, item.span});
    }
  }
  return made;
}

WeightedSum Resolver::weighted_sum(const Expression& instance, const Scope& scope, int depth) {
  WeightedSum made{members(instance, "members", scope, depth)};
  const auto by_index = by_name(made.members, [](const Member& member) { return member.index; });
  if (!spend(instance.items.size(), instance.span)) {
    return made;
  }
  for (const Item& item : instance.items) {
    if (!item.slot || item.slot->name != "weight" || item.value.kind != Kind::Value) {
      continue;
    }
    const auto weighed = by_index.find(item.slot->index.value_or(""));
    if (weighed != by_index.end()) {
      weighed->second->weight = effective(item, scope);
    }
  }
  return made;
}

Learner Resolver::learner(const Expression& instance, const Scope& scope, int depth) {
  Learner made;
  made.actions = members(instance, "society", scope, depth);
  made.triggers = members(instance, "triggers", scope, depth);
  if (!spend(instance.items.size(), instance.span)) {
    return made;
  }
  for (const Item& item : instance.items) {
    if (item.slot && item.slot->name == "reinforcers" && item.value.kind == Kind::Value) {
      const Value value = parse_value(item.value.name);
      if (const auto* numbers = std::get_if<Reinforcer>(&value)) {
        made.reinforcers.push_back(*numbers);
      }
    }
  }
  return made;
}

std::vector<Member> Resolver::members(const Expression& instance, std::string_view slot,
                                      const Scope& scope, int depth) {
  std::vector<Member> made;
  if (!spend(instance.items.size(), instance.span)) {
    return made;
  }
  for (const Item& item : instance.items) {
    const bool wanted = item.slot && (slot.empty() || item.slot->name == slot);
    if (wanted && item.value.kind != Kind::Value && item.value.kind != Kind::Nothing) {
      made.push_back(member(item, scope, depth));
    }
  }
  return made;
}

Member Resolver::member(const Item& item, const Scope& scope, int depth) {
  Member made;
  made.slot = item.slot->name;
  made.index = item.slot->index.value_or("");
  made.behaviour = behaviour(item.value, scope, depth);
  if (made.behaviour.description.empty()) {
    made.behaviour.description = item.slot->description.value_or("");
  }
  return made;
}

}  // namespace tacit::cdl
