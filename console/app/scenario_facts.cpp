#include "console/app/scenario_facts.h"

#include "idl/scenario/document.h"
#include "idl/types/config_error.h"
#include "idl/types/mission_kind.h"

namespace tacit {
namespace {

template <class Value>
Value required(Document& document, const std::string& file, const std::string& section,
               const std::string& key) {
  document.open(section);
  const auto found = document.find(section, key);
  const auto* value = found ? std::get_if<Value>(&found->value) : nullptr;
  if (value == nullptr) {
    throw ConfigError((found ? found->where : file) + ": [" + section + "] " + key + ": found " +
                      (found ? found->spelled : "nothing") +
                      ", wanted a scenario as resolved, with every parameter written out");
  }
  return *value;
}

/// A mission without waves of enemies has no strategy.
std::int64_t strategy_of(Document& document, const std::string& file) {
  const bool guard = mission_kind(required<std::string>(document, file, "scenario", "mission")) ==
                     MissionKind::Guard;
  return guard ? required<std::int64_t>(document, file, "enemies", "strategy") : 0;
}

}  // namespace

ScenarioFacts scenario_facts(std::string_view toml, const std::string& file) {
  Document document(toml, file);
  return {required<std::string>(document, file, "scenario", "name"),
          required<std::int64_t>(document, file, "run", "seed"),
          required<std::int64_t>(document, file, "robots", "count"),
          strategy_of(document, file),
          required<std::string>(document, file, "brain", "learner"),
          required<double>(document, file, "physics", "tick_s")};
}

}  // namespace tacit
