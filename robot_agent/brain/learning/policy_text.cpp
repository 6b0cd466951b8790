#include "robot_agent/brain/learning/policy_text.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "idl/types/config_error.h"
#include "robot_agent/brain/learning/role_triggers.h"

namespace tacit {
namespace {

using Json = nlohmann::json;

/// Reads the members of a policy; whatever is not as wanted is a ConfigError.
class PolicyReader {
 public:
  explicit PolicyReader(std::string_view name) : name_(name) {}

  [[noreturn]] void refuse(const std::string& what) const {
    throw ConfigError(name_ + ": " + what);
  }
  [[noreturn]] void refuse(const std::string& where, const Json& found,
                           const std::string& wanted) const {
    std::string text = found.dump(-1, ' ', false, Json::error_handler_t::replace);
    if (text.size() > 60) text = text.substr(0, 60) + "...";
    refuse(where + " is " + text + ", wanted " + wanted);
  }

  [[nodiscard]] Json document(std::string_view text) const {
    try {
      return Json::parse(text);
    } catch (const Json::exception& error) {
      refuse("is not JSON, or not all of it, wanted a policy as it was saved (" +
             std::string(error.what()) + ")");
    }
  }
  /// A member; null when it is not there.
  [[nodiscard]] static Json member(const Json& object, const char* key) {
    return object.is_object() && object.contains(key) ? object[key] : Json();
  }
  void want(const Json& object, const char* key, const Json& wanted) const {
    const Json found = member(object, key);
    if (found != wanted) refuse(key, found, wanted.dump());
  }
  [[nodiscard]] double number(const std::string& where, const Json& found, Range range) const {
    if (found.is_number()) {
      const auto value = found.get<double>();
      if (std::isfinite(value) && value >= range.min && value <= range.max) return value;
    }
    const bool bounded = std::isfinite(range.max);
    refuse(where, found, bounded ? "a number from 0 to 1" : "a finite number");
  }
  [[nodiscard]] std::uint64_t count(const std::string& where, const Json& found) const {
    if (!found.is_number_unsigned()) refuse(where, found, "a whole number, 0 or more");
    return found.get<std::uint64_t>();
  }

 private:
  std::string name_;
};

Json trigger_names() {
  Json names = Json::array();
  for (const RoleTrigger& trigger : kRoleTriggers) names.push_back(std::string(trigger.name));
  return names;
}

Json role_names() {
  Json names = Json::array();
  for (const std::string_view role : kRoleNames) names.push_back(std::string(role));
  return names;
}

void check_head(const PolicyReader& reader, const Json& policy) {
  if (!policy.is_object()) reader.refuse("the document", policy, "an object");
  reader.want(policy, "format", "tacit-policy");
  reader.want(policy, "version", 1);
  reader.want(policy, "learner", "q");
  reader.want(policy, "triggers", trigger_names());
  reader.want(policy, "roles", role_names());
}

RobotId read_robot(const PolicyReader& reader, const Json& policy) {
  const Json found = PolicyReader::member(policy, "robot");
  const std::uint64_t robot = reader.count("robot", found);
  if (robot < 1 || robot > 0xFFFF) reader.refuse("robot", found, "1 to 65535");
  return RobotId{static_cast<std::uint16_t>(robot)};
}

void read_schedule(const PolicyReader& reader, const Json& schedule, QTable& table) {
  const auto member = [&schedule](const char* key) { return PolicyReader::member(schedule, key); };
  table.alpha = reader.number("schedule.alpha", member("alpha"), {0.0, 1.0});
  table.epsilon = reader.number("schedule.epsilon", member("epsilon"), {0.0, 1.0});
  table.runs = reader.count("schedule.runs", member("runs"));
  table.updates = reader.count("schedule.updates", member("updates"));
  table.policy_changes = reader.count("schedule.policy_changes", member("policy_changes"));
}

/// The internal state that a row is about; empty when it names none.
std::optional<std::size_t> state_of(const Json& row) {
  const Json triggers = PolicyReader::member(row, "triggers");
  const Json role = PolicyReader::member(row, "role");
  if (!triggers.is_string() || !role.is_string()) return std::nullopt;
  const auto set = triggers_in(std::string_view(triggers.get_ref<const std::string&>()));
  const auto played = role_called(role.get_ref<const std::string&>());
  if (!set || !played) return std::nullopt;
  return internal_state(*set, *played);
}

std::string in_words(std::size_t state) {
  return "row \"" + words(triggers_in(state)) + "\" " + std::string(name(role_in(state)));
}

void read_row(const PolicyReader& reader, const Json& row, std::size_t state, QTable& table) {
  const Json q = PolicyReader::member(row, "q");
  const Json visits = PolicyReader::member(row, "visits");
  const std::string wanted = std::to_string(kRoles) + " numbers, one per role";
  if (!q.is_array() || q.size() != kRoles) reader.refuse(in_words(state) + ": q", q, wanted);
  if (!visits.is_array() || visits.size() != kRoles) {
    reader.refuse(in_words(state) + ": visits", visits, wanted);
  }
  for (std::size_t role = 0; role < kRoles; ++role) {
    const std::string of = " of " + std::string(kRoleNames[role]);
    const std::size_t cell = state * kRoles + role;
    table.q[cell] = reader.number(in_words(state) + ": q" + of, q[role], {});
    table.visits[cell] = reader.count(in_words(state) + ": visits" + of, visits[role]);
  }
}

void read_table(const PolicyReader& reader, const Json& rows, QTable& table) {
  if (!rows.is_array()) reader.refuse("table", rows, "a list of rows");
  table.actions = kRoles;
  table.q.resize(kInternalStates * kRoles);
  table.visits.resize(table.q.size());
  std::array<bool, kInternalStates> read{};
  for (const Json& row : rows) {
    const auto state = state_of(row);
    if (!state) reader.refuse("a row of the table", row, "triggers and role by their names");
    if (read[*state]) reader.refuse(in_words(*state) + " occurs twice");
    read[*state] = true;
    read_row(reader, row, *state, table);
  }
  const auto missing = std::find(read.begin(), read.end(), false);
  if (missing == read.end()) return;
  reader.refuse(in_words(static_cast<std::size_t>(missing - read.begin())) + " is missing");
}

void check_digest(const PolicyReader& reader, const Json& policy, const QTable& table) {
  if (!policy.contains("digest") || policy["digest"] == digest(table)) return;
  reader.refuse("digest", policy["digest"],
                digest(table) +
                    ": the table was changed after it was saved; to accept it on purpose, remove "
                    "the member digest");
}

OdometryVec place(const Json& pair, std::size_t at) {
  return {pair.at(at).get<double>(), pair.at(at + 1).get<double>()};
}

QuarryTrack::Record track(const Json& json) {
  QuarryTrack::Record record;
  record.count = json.at("count").get<std::uint64_t>();
  record.last_tick = json.at("tick").get<Tick>();
  for (const Json& fix : json.at("fixes")) record.fixes.push_back({place(fix, 0), place(fix, 2)});
  return record;
}

RunStand stand_in(const Json& json) {
  RunStand stand;
  stand.learner = json.at("learner").get<std::string>();
  stand.role = json.at("role").get<std::string>();
  stand.state = json.at("state").get<std::string>();
  const Json& at = json.at("entered_at");
  stand.entered = {json.at("entered").get<Tick>(),
                   {place(at, 0), {at.at(2).get<double>(), at.at(3).get<double>()}}};
  stand.disabled = json.at("disabled").get<bool>();
  if (json.contains("last")) {
    const Json& last = json["last"];
    stand.last = {last.at("state").get<std::size_t>(), last.at("action").get<std::size_t>()};
    stand.last_tick = last.at("tick").get<Tick>();
  }
  stand.triggers = json.at("triggers").get<std::uint64_t>();
  stand.chance = json.at("chance").get<std::uint64_t>();
  if (json.contains("base_m")) stand.perception.base_m = place(json["base_m"], 0);
  stand.perception.track = track(json.at("track"));
  return stand;
}

}  // namespace

PolicyTable parse_policy(std::string_view text, std::string_view name) {
  const PolicyReader reader(name);
  const Json json = reader.document(text);
  check_head(reader, json);
  PolicyTable policy{read_robot(reader, json), {}};
  read_schedule(reader, PolicyReader::member(json, "schedule"), policy.table);
  read_table(reader, PolicyReader::member(json, "table"), policy.table);
  check_digest(reader, json, policy.table);
  return policy;
}

std::optional<RunStand> parse_stand(std::string_view line) {
  try {
    const RunStand stand = stand_in(Json::parse(line));
    // Whatever else the text holds, or holds otherwise, was not written by `to_line`.
    if (to_line(stand) == line) return stand;
  } catch (const Json::exception&) {
    // Not a stand.
  }
  return std::nullopt;
}

}  // namespace tacit
