#pragma once

#include <compare>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace tacit {

/// What a person can place on a map for a team to do.
enum class Task : std::uint8_t {
  Biohazard,
  ExplosiveOrdnance,
  Waypoints,
  HostageMonitoring,
  SearchAndRescue
};
inline constexpr std::size_t kTasks = 5;
enum class Localization : std::uint8_t { UseLandmarks, UseMaps };
enum class Environment : std::uint8_t { Indoor, Outdoor };

/// Robots that a plan may be for.
inline constexpr int kMostPlannedRobots = 10;

/// Counts from 1 in the order of storing; never given twice.
using CaseId = std::uint64_t;

/// What a case is found by: all of it is known of a case.
struct CaseFeatures {
  Task task = Task::Waypoints;
  int robots = 1;  ///< 1 to kMostPlannedRobots.
  Localization localization = Localization::UseLandmarks;
  Environment environment = Environment::Indoor;
  bool handles_enemy = false;
  friend auto operator<=>(const CaseFeatures&, const CaseFeatures&) = default;
};

/// One task on the map, with what is wanted of it alone.
struct PlacedTask {
  Task task = Task::Waypoints;
  double x_m = 0.0;  ///< In the map's frame, as its file counts.
  double y_m = 0.0;
  std::optional<Localization> localization;
  std::optional<Environment> environment;
  std::optional<bool> handles_enemy;
  friend bool operator==(const PlacedTask&, const PlacedTask&) = default;
};

/// Tasks in one mission.
inline constexpr std::size_t kMostPlacedTasks = 64;
/// Plans in one answer.
inline constexpr std::size_t kMostPlans = 20;

/// What a person wants: tasks in their order, and constraints.
struct PlanRequest {
  std::vector<PlacedTask> tasks;
  std::optional<int> robots;  ///< 1 to kMostPlannedRobots; left open: as the best cases have it.
  bool enemy = false;         ///< An enemy is expected wherever a task does not say otherwise.
  double max_velocity_mps = 0.5;  ///< 0.1 to 1.
  double aggressiveness = 0.3;    ///< 0.1 to 1: the share of it that a robot goes at.
  std::size_t top = 3;            ///< Plans wanted, 1 to kMostPlans.
  bool naive = false;             ///< Without the wizard: a GoTo per task and nothing else.
  friend bool operator==(const PlanRequest&, const PlanRequest&) = default;
};

/// Bytes of a map or a mission that a wizard takes.
inline constexpr std::size_t kLongestPlanText = 4'000'000;

/// "Plan this."
struct AskForPlans {
  PlanRequest request;
  std::string map;  ///< Text of an overlay.
  friend bool operator==(const AskForPlans&, const AskForPlans&) = default;
};

/// "So it went", about a plan that the wizard gave or about a case. Nothing has to be remembered
/// between a plan and its outcome, so neither a wizard nor a client that starts anew loses one.
struct ReportOutcome {
  std::vector<CaseId> cases;          ///< That the plan was made from; at least one.
  double score = 0.0;                 ///< Of a debrief or of a person: 0 to 1.
  std::vector<std::string> failures;  ///< Sub-tasks that were not done, a sentence each.
  std::string map;                    ///< What the map is called.
  friend bool operator==(const ReportOutcome&, const ReportOutcome&) = default;
};

/// "Keep this": a finished mission becomes cases.
struct StoreMission {
  std::string mission;                 ///< In CDL.
  std::string title;                   ///< A short line.
  std::vector<CaseFeatures> features;  ///< Of its sub-missions in order; at least one.
  friend bool operator==(const StoreMission&, const StoreMission&) = default;
};

/// "Are you there, and how many cases do you have?"
struct AskForState {
  friend bool operator==(const AskForState&, const AskForState&) = default;
};

/// What somebody asks of the wizard. The wizard does one of the same client and number once, and
/// answers it again as often as it comes.
struct WizardRequest {
  std::uint64_t client = 0;  ///< Chosen by chance, not 0.
  std::uint64_t number = 0;  ///< Counts up from 1.
  std::variant<AskForPlans, ReportOutcome, StoreMission, AskForState> what;
  friend bool operator==(const WizardRequest&, const WizardRequest&) = default;
};

}  // namespace tacit
