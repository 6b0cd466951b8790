#include "wizard_service/cbr/features.h"

#include <algorithm>
#include <vector>

#include "idl/types/config_error.h"
#include "idl/types/lowered.h"
#include "idl/types/nearest_word.h"

namespace tacit::cbr {
namespace {

constexpr std::array<std::string_view, kTasks> kTaskWords{
    "BiohazardTask", "EODTask", "WaypointsTask", "HostageMonitoringTask", "SearchAndRescueTask"};
constexpr std::array<std::string_view, kMostPlannedRobots> kRobotWords{"1", "2", "3", "4", "5",
                                                                       "6", "7", "8", "9", "10"};
constexpr std::array<std::string_view, 2> kLocalizationWords{"UseLandmarks", "UseMaps"};
constexpr std::array<std::string_view, 2> kEnvironmentWords{"Indoor", "Outdoor"};
constexpr std::array<std::string_view, 2> kEnemyWords{"False", "True"};

constexpr std::array<FeatureRow, kFeatures> kTable{{
    {Feature::Task, "Task", 100, kTaskWords},
    {Feature::NumberOfRobots, "NumberOfRobots", 90, kRobotWords},
    {Feature::Localization, "Localization", 90, kLocalizationWords},
    {Feature::Environment, "Environment", 80, kEnvironmentWords},
    {Feature::HandlesEnemy, "HandlesEnemy", 70, kEnemyWords},
}};

struct OtherName {
  std::string_view name;
  std::string_view meant;
};

constexpr std::array<OtherName, 13> kTaskNames{{
    {"biohazard", "BiohazardTask"},
    {"bio", "BiohazardTask"},
    {"eod", "EODTask"},
    {"explosive", "EODTask"},
    {"mine", "EODTask"},
    {"waypoint", "WaypointsTask"},
    {"waypoints", "WaypointsTask"},
    {"hostage", "HostageMonitoringTask"},
    {"hostagemonitoring", "HostageMonitoringTask"},
    {"rescue", "SearchAndRescueTask"},
    {"sar", "SearchAndRescueTask"},
    {"search", "SearchAndRescueTask"},
    {"searchandrescue", "SearchAndRescueTask"},
}};

constexpr std::array<OtherName, 7> kFeatureNames{{
    {"missiontype", "Environment"},
    {"localizationmethod", "Localization"},
    {"enemyconsideration", "HandlesEnemy"},
    {"enemy", "HandlesEnemy"},
    {"robots", "NumberOfRobots"},
    {"numberofrobot", "NumberOfRobots"},
    {"tasktype", "Task"},
}};

/// Small letters, without blanks and the signs between words.
std::string bare(std::string_view name) {
  std::string out = lowered(name);
  std::erase_if(out, [](char c) { return c == ' ' || c == '-' || c == '_'; });
  return out;
}

template <class Names>
std::string_view meant(const Names& names, const std::string& name) {
  const auto found = std::find_if(names.begin(), names.end(),
                                  [&](const OtherName& one) { return one.name == name; });
  return found == names.end() ? std::string_view() : found->meant;
}

std::optional<std::size_t> index_in(std::span<const std::string_view> words,
                                    std::string_view name) {
  const std::string wanted = bare(name);
  const auto found = std::find_if(words.begin(), words.end(),
                                  [&](std::string_view word) { return bare(word) == wanted; });
  if (found == words.end()) return std::nullopt;
  return static_cast<std::size_t>(found - words.begin());
}

std::string listed(std::span<const std::string_view> words) {
  std::string text;
  for (const std::string_view word : words) text += (text.empty() ? "" : ", ") + std::string(word);
  return text;
}

std::string hint(std::string_view name, std::span<const std::string_view> words) {
  return did_you_mean(std::string(name), std::vector<std::string>(words.begin(), words.end()));
}

const FeatureRow& row_called(std::string_view name) {
  const std::string_view other = meant(kFeatureNames, bare(name));
  const std::string wanted = bare(other.empty() ? name : other);
  std::array<std::string_view, kFeatures> names{};
  for (std::size_t i = 0; i < kFeatures; ++i) {
    names[i] = kTable[i].name;
    if (bare(names[i]) == wanted) return kTable[i];
  }
  throw ConfigError("found a feature \"" + std::string(name) + "\", wanted one of " +
                    listed(names) + hint(name, names));
}

std::optional<std::size_t> value_in(const FeatureRow& row, std::string_view value) {
  if (row.feature == Feature::Task) {
    const std::string_view other = meant(kTaskNames, bare(value));
    return index_in(row.values, other.empty() ? value : other);
  }
  return index_in(row.values, value);
}

std::size_t value_called(const FeatureRow& row, std::string_view value) {
  if (const std::optional<std::size_t> index = value_in(row, value)) return *index;
  throw ConfigError("found " + std::string(row.name) + " \"" + std::string(value) +
                    "\", wanted one of " + listed(row.values) + hint(value, row.values));
}

template <class Value>
std::optional<std::size_t> index_of(const std::optional<Value>& value) {
  return value ? std::optional(static_cast<std::size_t>(*value)) : std::nullopt;
}

}  // namespace

const std::array<FeatureRow, kFeatures>& feature_table() { return kTable; }

std::size_t code(const CaseFeatures& features, Feature feature) {
  switch (feature) {
    case Feature::Task:
      return static_cast<std::size_t>(features.task);
    case Feature::NumberOfRobots:
      return static_cast<std::size_t>(features.robots - 1);
    case Feature::Localization:
      return static_cast<std::size_t>(features.localization);
    case Feature::Environment:
      return static_cast<std::size_t>(features.environment);
    case Feature::HandlesEnemy:
      return features.handles_enemy ? 1 : 0;
  }
  return 0;
}

std::optional<std::size_t> code(const Query& query, Feature feature) {
  switch (feature) {
    case Feature::Task:
      return index_of(query.task);
    case Feature::NumberOfRobots:
      return query.robots ? std::optional(static_cast<std::size_t>(*query.robots - 1))
                          : std::nullopt;
    case Feature::Localization:
      return index_of(query.localization);
    case Feature::Environment:
      return index_of(query.environment);
    case Feature::HandlesEnemy:
      return index_of(query.handles_enemy);
  }
  return std::nullopt;
}

void set_code(CaseFeatures& features, Feature feature, std::size_t code) {
  switch (feature) {
    case Feature::Task:
      features.task = static_cast<Task>(code);
      break;
    case Feature::NumberOfRobots:
      features.robots = static_cast<int>(code) + 1;
      break;
    case Feature::Localization:
      features.localization = static_cast<Localization>(code);
      break;
    case Feature::Environment:
      features.environment = static_cast<Environment>(code);
      break;
    case Feature::HandlesEnemy:
      features.handles_enemy = code != 0;
      break;
  }
}

std::string_view word(Task task) { return kTaskWords[static_cast<std::size_t>(task)]; }
std::string_view word(Localization localization) {
  return kLocalizationWords[static_cast<std::size_t>(localization)];
}
std::string_view word(Environment environment) {
  return kEnvironmentWords[static_cast<std::size_t>(environment)];
}

Task task_called(std::string_view name) { return static_cast<Task>(value_called(kTable[0], name)); }

void set_feature(CaseFeatures& features, std::string_view name, std::string_view value) {
  const FeatureRow& row = row_called(name);
  set_code(features, row.feature, value_called(row, value));
}

CaseFeatures usual_features(Task task) {
  CaseFeatures usual;
  usual.task = task;
  const bool outdoors = task == Task::ExplosiveOrdnance || task == Task::Waypoints;
  usual.environment = outdoors ? Environment::Outdoor : Environment::Indoor;
  usual.localization = task == Task::Waypoints ? Localization::UseMaps : Localization::UseLandmarks;
  usual.handles_enemy = task == Task::HostageMonitoring;
  return usual;
}

std::string to_text(const CaseFeatures& features) {
  std::string text;
  for (const FeatureRow& row : kTable) {
    text += (text.empty() ? "" : ", ") + std::string(row.name) + ' ' +
            std::string(row.values[code(features, row.feature)]);
  }
  return text;
}

}  // namespace tacit::cbr
