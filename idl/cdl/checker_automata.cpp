#include <algorithm>
#include <array>
#include <set>

#include "idl/cdl/checker.h"
#include "idl/cdl/label.h"

namespace tacit::cdl {
namespace {

using Kind = Expression::Kind;
using Targets = std::map<std::string_view, std::vector<std::string_view>>;

bool is_indexed(const Item& item, std::string_view name) {
  return item.slot && item.slot->index && item.slot->name == name;
}

/// Where the rules of each state lead.
Targets targets(const Expression& automaton) {
  Targets made;
  for (const Item& item : automaton.items) {
    if (is_indexed(item, "rules") && item.value.kind == Kind::Rule) {
      made[*item.slot->index].push_back(item.value.name);
    }
  }
  return made;
}

/// "State3 ($AN_12)": what the editor shows and what the file says.
std::string shown(std::string_view name, const Item& state) {
  const std::string label = label_of(state.slot->description.value_or(""));
  return label.empty() || label == name ? std::string(name)
                                        : label + " (" + std::string(name) + ')';
}

/// Whether a mission may end in that state.
bool is_ending(const Item& state) {
  static constexpr std::array<std::string_view, 5> kEndings{"Stop", "Terminate", "TerminateMission",
                                                            "ExitTask", "Standby*"};
  const Expression* body = state.value.kind == Kind::Group ? body_of(state.value) : &state.value;
  // What another statement or automaton does is not looked into.
  return body == nullptr || body->kind != Kind::Reference || body->name.starts_with('$') ||
         std::find(kEndings.begin(), kEndings.end(), body->name) != kEndings.end();
}

/// Names to compare a wrong one with; comparing takes time for each letter.
std::vector<std::string> some_names(const std::map<std::string_view, const Item*>& states) {
  constexpr std::size_t kMostCompared = 100;
  constexpr std::size_t kLongestCompared = 64;
  std::vector<std::string> names;
  for (const auto& [state, item] : states) {
    if (names.size() < kMostCompared && state.size() <= kLongestCompared) {
      names.emplace_back(state);
    }
  }
  return names;
}

}  // namespace

void Checker::automaton(const Expression& instance) {
  const States all = states(instance);
  if (!all.contains("Start")) {
    find(Severity::Error, "no-start", "the automaton has no state Start: society[Start] = …",
         instance.span);
  }
  rules(instance, all);
  reachable(instance, all);
  dead_ends(instance, all);
}

Checker::States Checker::states(const Expression& instance) {
  States all;
  for (const Item& item : instance.items) {
    if (is_indexed(item, "society") && !all.emplace(*item.slot->index, &item).second) {
      find(Severity::Error, "duplicate-state", "a second state " + shown(*item.slot->index, item),
           item.span);
    }
  }
  return all;
}

void Checker::rules(const Expression& instance, const States& states) {
  const std::vector<std::string> names = some_names(states);
  for (const Item& item : instance.items) {
    if (!is_indexed(item, "rules")) {
      continue;
    }
    const std::string& from = *item.slot->index;
    const auto add = [&](const char* rule, const std::string& text, const std::string& name) {
      find(Severity::Error, rule, text + name + hint(name, names), item.span);
    };
    if (!states.contains(from)) {
      add("rule-of-no-state", "a rule of a state that is not there: ", from);
    }
    if (item.value.kind != Kind::Rule) {
      add("no-rule", "wanted \"if … goto …\" for ", from);
    } else if (!states.contains(item.value.name)) {
      add("goto-nowhere", "goto to a state that is not there: ", item.value.name);
    }
  }
}

void Checker::reachable(const Expression& instance, const States& states) {
  const Targets out = targets(instance);
  std::set<std::string_view> reached;
  std::vector<std::string_view> left{"Start"};
  while (!left.empty()) {
    const std::string_view state = left.back();
    left.pop_back();
    const auto next = out.find(state);
    if (reached.insert(state).second && next != out.end()) {
      left.insert(left.end(), next->second.begin(), next->second.end());
    }
  }
  for (const auto& [name, item] : states) {
    if (!reached.contains(name) && states.contains("Start")) {
      find(Severity::Warning, "unreachable-state",
           "no rules lead from Start to the state " + shown(name, *item), item->span);
    }
  }
}

void Checker::dead_ends(const Expression& instance, const States& states) {
  const Targets out = targets(instance);
  for (const auto& [name, item] : states) {
    if (!out.contains(name) && !is_ending(*item)) {
      find(Severity::Warning, "no-way-out", "no rule leads out of the state " + shown(name, *item),
           item->span);
    }
  }
}

void Checker::doubles() {
  for (const Statement* statement : names_.doubles()) {
    find(Severity::Error, "duplicate-name", "a second statement named " + statement->name,
         statement->span);
  }
}

void Checker::circles() {
  enum class Seen { Not, Open, Done };
  std::vector<Seen> seen(mission_.statements.size(), Seen::Not);
  std::vector<std::pair<std::size_t, std::size_t>> path;  // A statement, its next reference.
  for (std::size_t root = 0; root < seen.size(); ++root) {
    if (seen[root] == Seen::Not) {
      seen[root] = Seen::Open;
      path.emplace_back(root, 0);
    }
    while (!path.empty()) {
      auto& [at, next] = path.back();
      if (next == references_[at].size()) {
        seen[at] = Seen::Done;
        path.pop_back();
        continue;
      }
      const Expression& reference = *references_[at][next++];
      const auto to =
          static_cast<std::size_t>(names_.find(reference.name) - mission_.statements.data());
      if (seen[to] == Seen::Open) {
        find(Severity::Error, "circle", reference.name + " is made from itself: names in a circle",
             reference.span);
      } else if (seen[to] == Seen::Not) {
        seen[to] = Seen::Open;
        path.emplace_back(to, 0);
      }
    }
  }
}

}  // namespace tacit::cdl
