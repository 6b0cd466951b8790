#include "wizard_service/client/plan_json.h"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <nlohmann/json.hpp>

#include "idl/types/config_error.h"
#include "idl/types/nearest_word.h"
#include "wizard_service/cbr/features.h"

namespace tacit {
namespace {

using nlohmann::json;

json to_json(const UsedCase& used) {
  json features = json::array();
  for (const FeatureMatch& match : used.features) {
    features.push_back({{"feature", match.feature},
                        {"wanted", match.wanted},
                        {"found", match.found},
                        {"matches", match.matches}});
  }
  return {{"id", used.id},
          {"title", used.title},
          {"task", used.task},
          {"record", used.record},
          {"features", std::move(features)}};
}

json to_json(const PlanChange& change) {
  return {{"step", change.step == PlanChange::Step::Adapt ? "adapt" : "criticize"},
          {"rule", change.rule},
          {"why", change.why},
          {"before", change.before},
          {"after", change.after},
          {"mended", change.mended}};
}

json to_json(const OfferedPlan& plan) {
  json cases = json::array();
  json changes = json::array();
  for (const UsedCase& used : plan.cases) cases.push_back(to_json(used));
  for (const PlanChange& change : plan.changes) changes.push_back(to_json(change));
  return {{"stars", plan.stars},
          {"arrangement", plan.arrangement},
          {"cases", std::move(cases)},
          {"changes", std::move(changes)},
          {"mission", plan.mission}};
}

[[noreturn]] void refuse(const std::string& where, const std::string& found,
                         const std::string& wanted) {
  throw ConfigError(where + ": found " + found + ", wanted " + wanted);
}

void refuse_other_keys(const json& object, const std::string& where,
                       const std::vector<std::string>& known) {
  if (!object.is_object()) refuse(where, object.dump().substr(0, 100), "an object");
  for (const auto& [key, value] : object.items()) {
    if (std::find(known.begin(), known.end(), key) != known.end()) continue;
    throw ConfigError(where + ": there is no \"" + key + '"' + did_you_mean(key, known));
  }
}

double number(const json& object, const char* key, const std::string& where) {
  const auto at = object.find(key);
  if (at == object.end()) refuse(where, std::string("no ") + key, "a number");
  if (!at->is_number()) refuse(where + ", " + key, at->dump().substr(0, 100), "a number");
  return at->get<double>();
}

int whole(const json& value, const std::string& where) {
  constexpr std::int64_t kMost = std::numeric_limits<int>::max();
  const bool fits = value.is_number_integer() && value.get<std::int64_t>() >= -kMost &&
                    value.get<std::int64_t>() <= kMost;
  if (!fits) refuse(where, value.dump().substr(0, 100), "a whole number");
  return value.get<int>();
}

bool flag(const json& value, const std::string& where) {
  if (!value.is_boolean()) refuse(where, value.dump().substr(0, 100), "true or false");
  return value.get<bool>();
}

std::string word(const json& value, const std::string& where) {
  if (!value.is_string()) refuse(where, value.dump().substr(0, 100), "a word");
  return value.get<std::string>();
}

/// Whether the member is there and not null.
const json* given(const json& object, const char* key) {
  const auto at = object.find(key);
  return at == object.end() || at->is_null() ? nullptr : &*at;
}

/// Also as cases have it: "UseMaps".
Localization localization_from(const json& value, const std::string& where) {
  const std::string text = word(value, where + ", localization");
  if (text == "maps" || text == "UseMaps") return Localization::UseMaps;
  if (text == "landmarks" || text == "UseLandmarks") return Localization::UseLandmarks;
  refuse(where + ", localization", '"' + text + '"', "maps or landmarks");
}

/// Also as cases have it: "Indoor".
Environment environment_from(const json& value, const std::string& where) {
  const std::string text = word(value, where + ", environment");
  if (text == "indoor" || text == "Indoor") return Environment::Indoor;
  if (text == "outdoor" || text == "Outdoor") return Environment::Outdoor;
  refuse(where + ", environment", '"' + text + '"', "indoor or outdoor");
}

Task kind_from(const json& object, const std::string& where) {
  const json* kind = given(object, "task");
  if (kind == nullptr) refuse(where, "no task", "biohazard, eod, waypoint, hostage or rescue");
  try {
    return cbr::task_called(word(*kind, where + ", task"));
  } catch (const ConfigError& error) {
    throw ConfigError(where + ": " + error.what());
  }
}

CaseFeatures features_from(const json& object, const std::string& where) {
  refuse_other_keys(object, where,
                    {"task", "robots", "localization", "environment", "handles_enemy"});
  CaseFeatures features = cbr::usual_features(kind_from(object, where));
  if (const json* value = given(object, "robots")) features.robots = whole(*value, where);
  if (const json* value = given(object, "localization")) {
    features.localization = localization_from(*value, where);
  }
  if (const json* value = given(object, "environment")) {
    features.environment = environment_from(*value, where);
  }
  if (const json* value = given(object, "handles_enemy")) {
    features.handles_enemy = flag(*value, where + ", handles_enemy");
  }
  return features;
}

PlacedTask task_from(const json& object, const std::string& where) {
  refuse_other_keys(object, where,
                    {"task", "x", "y", "localization", "environment", "handles_enemy"});
  PlacedTask task;
  task.task = kind_from(object, where);
  task.x_m = number(object, "x", where);
  task.y_m = number(object, "y", where);
  if (const json* value = given(object, "localization")) {
    task.localization = localization_from(*value, where);
  }
  if (const json* value = given(object, "environment")) {
    task.environment = environment_from(*value, where);
  }
  if (const json* value = given(object, "handles_enemy")) {
    task.handles_enemy = flag(*value, where + ", handles_enemy");
  }
  return task;
}

}  // namespace

std::string to_json(const PlanAnswer& answer) {
  json plans = json::array();
  for (const OfferedPlan& plan : answer.plans) plans.push_back(to_json(plan));
  const json all{{"plans", std::move(plans)}, {"notes", answer.notes}};
  return all.dump(2, ' ', false, json::error_handler_t::replace);
}

PlanRequest plan_request_from_json(std::string_view text) {
  const json object = json::parse(text, nullptr, false);
  if (object.is_discarded()) throw ConfigError("request: is no JSON");
  refuse_other_keys(
      object, "request",
      {"tasks", "robots", "enemy", "max_velocity_mps", "aggressiveness", "top", "naive"});
  PlanRequest request;
  const json* tasks = given(object, "tasks");
  if (tasks == nullptr || !tasks->is_array()) refuse("request", "no tasks", "a list of them");
  for (std::size_t i = 0; i < tasks->size(); ++i) {
    request.tasks.push_back(task_from((*tasks)[i], "task " + std::to_string(i + 1)));
  }
  if (const json* value = given(object, "robots")) request.robots = whole(*value, "robots");
  if (const json* value = given(object, "enemy")) request.enemy = flag(*value, "enemy");
  if (const json* value = given(object, "naive")) request.naive = flag(*value, "naive");
  if (given(object, "max_velocity_mps") != nullptr) {
    request.max_velocity_mps = number(object, "max_velocity_mps", "request");
  }
  if (given(object, "aggressiveness") != nullptr) {
    request.aggressiveness = number(object, "aggressiveness", "request");
  }
  if (const json* value = given(object, "top")) {
    const int top = whole(*value, "top");
    if (top < 0) refuse("top", std::to_string(top), "1 to " + std::to_string(kMostPlans));
    request.top = static_cast<std::size_t>(top);
  }
  return request;
}

std::vector<CaseFeatures> case_features_from_json(std::string_view text) {
  const json list = json::parse(text, nullptr, false);
  if (!list.is_array()) refuse("features", "no list", "one");
  std::vector<CaseFeatures> all;
  for (std::size_t i = 0; i < list.size(); ++i) {
    all.push_back(features_from(list[i], "features " + std::to_string(i + 1)));
  }
  return all;
}

}  // namespace tacit
