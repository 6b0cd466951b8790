#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "idl/types/plan_request.h"

namespace tacit::cbr {

/// What a case is looked for by; what is left open matches anything.
struct Query {
  std::optional<Task> task;
  std::optional<int> robots;
  std::optional<Localization> localization;
  std::optional<Environment> environment;
  std::optional<bool> handles_enemy;
};

/// The features in the order of the discrimination tree: by weight.
enum class Feature : std::uint8_t {
  Task,
  NumberOfRobots,
  Localization,
  Environment,
  HandlesEnemy,
};
inline constexpr std::size_t kFeatures = 5;

/// One feature's row of the table of features.
struct FeatureRow {
  Feature feature;
  std::string_view name;                     ///< As MissionLab calls it.
  int weight;                                ///< In hundredths.
  std::span<const std::string_view> values;  ///< The index of a value is its code.
};

/// The indexing features, heaviest first (MissionLab's table of 2004, with the number of robots as
/// in 2003).
[[nodiscard]] const std::array<FeatureRow, kFeatures>& feature_table();

/// A feature's value as an index into its row's values.
[[nodiscard]] std::size_t code(const CaseFeatures& features, Feature feature);
[[nodiscard]] std::optional<std::size_t> code(const Query& query, Feature feature);
/// Sets one by its index.
void set_code(CaseFeatures& features, Feature feature, std::size_t code);

/// "BiohazardTask", "UseMaps", "Indoor", …
[[nodiscard]] std::string_view word(Task task);
[[nodiscard]] std::string_view word(Localization localization);
[[nodiscard]] std::string_view word(Environment environment);

/// "biohazard", "BiohazardTask", "bio", "eod", "waypoint", "hostage", "rescue", …; letters' case
/// does not count. Throws ConfigError that names all when it is none.
[[nodiscard]] Task task_called(std::string_view name);

/// Sets the feature that is called `name` to what `value` says; the names of MissionLab's older
/// tables ("MissionType" for the environment) are known too. Throws ConfigError when either is
/// unknown: what was found and what was wanted.
void set_feature(CaseFeatures& features, std::string_view name, std::string_view value);

/// What is usual for a task: EOD and waypoints outdoors, hostages with an enemy, …
[[nodiscard]] CaseFeatures usual_features(Task task);

/// "Task BiohazardTask, NumberOfRobots 2, …"
[[nodiscard]] std::string to_text(const CaseFeatures& features);

}  // namespace tacit::cbr
