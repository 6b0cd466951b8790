#include "robot_agent/brain/learning/policy_table.h"

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>

#include "idl/types/config_error.h"
#include "idl/types/shortest.h"
#include "robot_agent/brain/learning/role_triggers.h"

namespace tacit {
namespace {

/// FNV-1a, 64 bits, a byte at a time from the low end.
class Fnv {
 public:
  void add(std::uint64_t value) {
    for (int byte = 0; byte < 8; ++byte) {
      hash_ = (hash_ ^ (value >> 8 * byte & 0xFFU)) * 0x100000001B3;
    }
  }
  [[nodiscard]] std::uint64_t value() const { return hash_; }

 private:
  std::uint64_t hash_ = 0xCBF29CE484222325;
};

std::string quoted(std::string_view text) { return '"' + std::string(text) + '"'; }

template <class Values, class Print>
std::string listed(const Values& values, Print print) {
  std::string text = "[";
  for (const auto& value : values) {
    if (text.size() > 1) text += ", ";
    text += print(value);
  }
  return text + "]";
}

std::span<const std::uint64_t> visits(const QTable& table, std::size_t state) {
  return std::span(table.visits).subspan(state * table.actions, table.actions);
}

std::string row_text(const QTable& table, std::size_t state) {
  const TriggerSet triggers = triggers_in(state);
  const auto whole = [](std::uint64_t value) { return std::to_string(value); };
  return R"({"triggers": )" + quoted(words(triggers)) + R"(, "role": )" +
         quoted(name(role_in(state))) + R"(, "q": )" + listed(table.row(state), json_number) +
         R"(, "visits": )" + listed(visits(table, state), whole) +
         (feasible(triggers) ? "}" : R"(, "feasible": false})");
}

std::string schedule_text(const QTable& table) {
  return R"({"alpha": )" + json_number(table.alpha) + R"(, "epsilon": )" +
         json_number(table.epsilon) + R"(, "runs": )" + std::to_string(table.runs) +
         R"(, "updates": )" + std::to_string(table.updates) + R"(, "policy_changes": )" +
         std::to_string(table.policy_changes) + "}";
}

std::string for_people(double value) {
  std::array<char, 64> digits{};
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value,
                                 std::chars_format::general, 5)
                       .ptr;
  return {digits.data(), end};
}

std::vector<std::string> state_words(std::size_t state) {
  const std::string triggers = words(triggers_in(state));
  return {triggers.empty() ? "none" : triggers, std::string(name(role_in(state)))};
}

std::string best_role(const QTable& table, std::size_t state) {
  return std::string(name(static_cast<Role>(table.greedy(state))));
}

template <class Visit>
void for_each_feasible(Visit visit) {
  for (std::size_t state = 0; state < kInternalStates; ++state) {
    if (feasible(triggers_in(state))) visit(state);
  }
}

bool equal_rows(const QTable& a, const QTable& b, std::size_t state) {
  return std::ranges::equal(a.row(state), b.row(state)) &&
         std::ranges::equal(visits(a, state), visits(b, state));
}

double merged_value(std::span<const PolicyTable> policies, std::size_t cell) {
  double weighted = 0.0;
  double weight = 0.0;
  double sum = 0.0;
  for (const PolicyTable& policy : policies) {
    const auto count = static_cast<double>(policy.table.visits[cell]);
    weighted += count * policy.table.q[cell];
    weight += count;
    sum += policy.table.q[cell];
  }
  return weight > 0.0 ? weighted / weight : sum / static_cast<double>(policies.size());
}

}  // namespace

std::string digest(const QTable& table) {
  Fnv hash;
  for (const double value : table.q) hash.add(std::bit_cast<std::uint64_t>(value));
  for (const std::uint64_t count : table.visits) hash.add(count);
  std::array<char, 16> digits{};
  digits.fill('0');
  std::array<char, 16> raw{};
  const auto end = std::to_chars(raw.data(), raw.data() + raw.size(), hash.value(), 16).ptr;
  std::copy(raw.data(), end, digits.data() + (raw.data() + raw.size() - end));
  return {digits.data(), digits.size()};
}

std::string to_text(const PolicyTable& policy) {
  const auto trigger_name = [](const RoleTrigger& each) { return quoted(each.name); };
  std::string text = "{\n  \"format\": \"tacit-policy\",\n  \"version\": 1,\n  \"learner\": \"q\",";
  text += "\n  \"robot\": " + std::to_string(policy.robot.value);
  text += ",\n  \"triggers\": " + listed(kRoleTriggers, trigger_name);
  text += ",\n  \"roles\": " + listed(kRoleNames, quoted);
  text += ",\n  \"schedule\": " + schedule_text(policy.table);
  text += ",\n  \"table\": [";
  for (std::size_t state = 0; state < kInternalStates; ++state) {
    text += (state == 0 ? "\n    " : ",\n    ") + row_text(policy.table, state);
  }
  return text + "\n  ],\n  \"digest\": " + quoted(digest(policy.table)) + "\n}\n";
}

TextRows show(const PolicyTable& policy) {
  std::vector<std::string> headings{"triggers", "role"};
  for (const std::string_view role : kRoleNames) headings.push_back("q " + std::string(role));
  for (const std::string_view role : kRoleNames) headings.push_back("visits " + std::string(role));
  headings.emplace_back("best");
  TextRows rows{headings};
  for_each_feasible([&](std::size_t state) {
    std::vector<std::string>& row = rows.emplace_back(state_words(state));
    for (const double value : policy.table.row(state)) row.push_back(for_people(value));
    for (const std::uint64_t n : visits(policy.table, state)) row.push_back(std::to_string(n));
    row.push_back(best_role(policy.table, state));
  });
  return rows;
}

TextRows diff(const PolicyTable& before, const PolicyTable& after) {
  std::vector<std::string> headings{"triggers", "role", "best before", "best after"};
  for (const std::string_view role : kRoleNames) headings.push_back("q " + std::string(role));
  TextRows rows{headings};
  for_each_feasible([&](std::size_t state) {
    if (equal_rows(before.table, after.table, state)) return;
    std::vector<std::string>& row = rows.emplace_back(state_words(state));
    row.push_back(best_role(before.table, state));
    row.push_back(best_role(after.table, state));
    for (std::size_t role = 0; role < kRoles; ++role) {
      row.push_back(for_people(before.table.row(state)[role]) + " -> " +
                    for_people(after.table.row(state)[role]));
    }
  });
  return rows;
}

PolicyTable merge(std::span<const PolicyTable> policies, RobotId robot) {
  if (policies.empty()) throw ConfigError("there are no policies to merge, wanted at least one");
  PolicyTable merged{robot, policies.front().table};
  QTable& table = merged.table;
  for (std::size_t cell = 0; cell < table.q.size(); ++cell) {
    table.q[cell] = merged_value(policies, cell);
  }
  for (const PolicyTable& policy : policies.subspan(1)) {
    const QTable& other = policy.table;
    for (std::size_t cell = 0; cell < table.visits.size(); ++cell) {
      table.visits[cell] += other.visits[cell];
    }
    table.alpha = std::max(table.alpha, other.alpha);
    table.epsilon = std::max(table.epsilon, other.epsilon);
    table.runs += other.runs;
    table.updates += other.updates;
    table.policy_changes += other.policy_changes;
  }
  return merged;
}

}  // namespace tacit
