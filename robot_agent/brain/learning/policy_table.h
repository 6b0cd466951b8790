#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "idl/types/ids.h"
#include "robot_agent/brain/learning/q_learner.h"

namespace tacit {

/// What one robot has learned about when to play which role; docs/policy.md shows it as a file.
struct PolicyTable {
  RobotId robot;
  QTable table;  ///< Of `kInternalStates` states and `kRoles` actions.
  friend bool operator==(const PolicyTable&, const PolicyTable&) = default;
};

/// The policy as JSON, a line per internal state, with a digest.
[[nodiscard]] std::string to_text(const PolicyTable& policy);
/// The inverse, bit for bit. Throws ConfigError, which begins with `name`, when the text is not a
/// policy of this version, with these triggers and roles, whole, with numbers that can be, and as
/// it was saved (unless it has no digest).
[[nodiscard]] PolicyTable parse_policy(std::string_view text, std::string_view name);

/// Over all values and visits: 16 hexadecimal digits.
[[nodiscard]] std::string digest(const QTable& table);

/// A table for people: first the headings, then the rows.
using TextRows = std::vector<std::vector<std::string>>;

/// The feasible internal states: triggers, role, values and visits by role, best role.
[[nodiscard]] TextRows show(const PolicyTable& policy);
/// The feasible internal states in which the two differ: triggers, role, best role in each, values
/// in each by role.
[[nodiscard]] TextRows diff(const PolicyTable& before, const PolicyTable& after);
/// One policy out of several, for `robot`: values weighted by visits (plain means where nobody has
/// been), counters added up, the largest of the rates. Throws ConfigError when there are none.
[[nodiscard]] PolicyTable merge(std::span<const PolicyTable> policies, RobotId robot);

}  // namespace tacit
