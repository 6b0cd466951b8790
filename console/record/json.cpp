#include "console/record/json.h"

#include <nlohmann/json.hpp>

#include "idl/types/config_error.h"

namespace tacit {
namespace {

using Json = nlohmann::ordered_json;

std::string shown(const Json& value) {
  return value.dump(-1, ' ', false, Json::error_handler_t::replace);
}

Json value_of(const decltype(RecordedMetric::value)& value) {
  return value ? std::visit([](auto number) { return Json(number); }, *value) : Json();
}

Json object_of(const std::vector<RecordedMetric>& metrics) {
  Json object = Json::object();
  for (const RecordedMetric& metric : metrics) {
    object[metric.key] = value_of(metric.value);
  }
  return object;
}

/// An object that says where a wrong member is.
class Object {
 public:
  Object(std::string_view text, std::string where) : where_(std::move(where)) {
    object_ = Json::parse(text, nullptr, false);
    if (object_.is_discarded() || !object_.is_object()) {
      throw ConfigError(where_ + ": is not a JSON object");
    }
  }

  void read(const char* key, std::string& value) const {
    value = member(key, "a text", [](const Json& j) { return j.is_string(); });
  }
  void read(const char* key, bool& value) const {
    value = member(key, "true or false", [](const Json& j) { return j.is_boolean(); });
  }
  void read(const char* key, double& value) const {
    value = member(key, "a number", [](const Json& j) { return j.is_number(); });
  }
  void read(const char* key, std::int64_t& value) const {
    value = member(key, "a whole number", [](const Json& j) { return j.is_number_integer(); });
  }
  void read(const char* key, std::uint64_t& value) const {
    value = member(key, "a whole number, 0 or more",
                   [](const Json& j) { return j.is_number_unsigned(); });
  }
  void read(const char* key, std::vector<std::string>& value) const {
    value = member(key, "a list of texts", [](const Json& j) {
      return j.is_array() && std::all_of(j.begin(), j.end(), [](auto& e) { return e.is_string(); });
    });
  }
  [[nodiscard]] std::vector<RecordedMetric> metrics(const char* key) const {
    return metrics_of(member(key, "an object", [](const Json& j) { return j.is_object(); }));
  }
  [[nodiscard]] std::vector<RecordedMetric> metrics() const { return metrics_of(object_); }

 private:
  template <class Test>
  const Json& member(const char* key, const char* wanted, Test test) const {
    const auto found = object_.find(key);
    if (found == object_.end() || !test(*found)) {
      refuse(key, found == object_.end() ? "nothing" : shown(*found), wanted);
    }
    return *found;
  }
  [[nodiscard]] std::vector<RecordedMetric> metrics_of(const Json& object) const {
    std::vector<RecordedMetric> metrics;
    for (const auto& [key, value] : object.items()) {
      if (value.is_number_unsigned()) {
        metrics.push_back({key, value.get<std::uint64_t>()});
      } else if (value.is_number()) {
        metrics.push_back({key, value.get<double>()});
      } else if (value.is_null()) {
        metrics.push_back({key, std::nullopt});
      } else {
        refuse(key, shown(value), "a number or null");
      }
    }
    return metrics;
  }
  [[noreturn]] void refuse(const std::string& key, const std::string& found,
                           const std::string& wanted) const {
    throw ConfigError(where_ + ": " + key + ": found " + found + ", wanted " + wanted);
  }

  std::string where_;
  Json object_;
};

std::string text_of(const Json& object) {
  return object.dump(2, ' ', false, Json::error_handler_t::replace) + '\n';
}

}  // namespace

std::string to_json(const RunFacts& facts) {
  return text_of({{"key", facts.key},
                  {"version", facts.version},
                  {"scenario", facts.scenario},
                  {"seed", facts.seed},
                  {"transport", facts.transport},
                  {"robots", facts.robots},
                  {"learner", facts.learner},
                  {"strategy", facts.strategy},
                  {"command_line", facts.command_line},
                  {"started", facts.started}});
}

std::string to_json(const RunOutcome& outcome) {
  const auto speed = outcome.ticks_per_s();
  return text_of({{"complete", outcome.complete},
                  {"incomplete_because", outcome.incomplete_because},
                  {"repeatable", outcome.repeatable},
                  {"ticks", outcome.ticks},
                  {"events", outcome.events},
                  {"wall_s", outcome.wall_s},
                  {"ticks_per_s", speed ? Json(*speed) : Json()},
                  {"event_log_sha256", outcome.event_log_sha256},
                  {"metrics", object_of(outcome.metrics)}});
}

std::string to_json(const std::vector<RecordedMetric>& metrics) {
  return shown(object_of(metrics));
}

RunFacts facts_from_json(std::string_view text, const std::string& where) {
  const Object object(text, where);
  RunFacts facts;
  object.read("key", facts.key);
  object.read("version", facts.version);
  object.read("scenario", facts.scenario);
  object.read("seed", facts.seed);
  object.read("transport", facts.transport);
  object.read("robots", facts.robots);
  object.read("learner", facts.learner);
  object.read("strategy", facts.strategy);
  object.read("command_line", facts.command_line);
  object.read("started", facts.started);
  return facts;
}

RunOutcome outcome_from_json(std::string_view text, const std::string& where) {
  const Object object(text, where);
  RunOutcome outcome;
  object.read("complete", outcome.complete);
  object.read("incomplete_because", outcome.incomplete_because);
  object.read("repeatable", outcome.repeatable);
  object.read("ticks", outcome.ticks);
  object.read("events", outcome.events);
  object.read("wall_s", outcome.wall_s);
  object.read("event_log_sha256", outcome.event_log_sha256);
  outcome.metrics = object.metrics("metrics");
  return outcome;
}

std::vector<RecordedMetric> metrics_from_json(std::string_view text, const std::string& where) {
  return Object(text, where).metrics();
}

}  // namespace tacit
