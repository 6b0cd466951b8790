#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "deploy/experiment/crew.h"
#include "deploy/experiment/flight.h"
#include "deploy/lockstep/compose_operation.h"
#include "idl/overlay/plan.h"
#include "idl/types/plan_request.h"
#include "wizard_service/cbr/case_shelf.h"

namespace tacit {

/// Where the mission of a flight comes from: the wizard's best plan; a GoTo per task; a mission
/// that an expert wrote.
enum class Planner : std::uint8_t { Wizard, Naive, Expert };
[[nodiscard]] const char* word(Planner planner);

/// The sites of a study are that many.
inline constexpr std::size_t kMostSites = 100'000;

/// Missions by the wizard, by a person without it and by an expert, each carried out once on the
/// same sites, with the site's seed as the flight's. The expert's missions are for the building
/// alone and begin in its hallway, so that of them the way points are not wanted. [ours, after the
/// usability test of the mission wizard]
struct WizardStudy {
  std::size_t sites = 200;  ///< 1 to kMostSites.
  std::uint64_t first = 1;  ///< Seed of the first site; the next has the next.
  std::vector<int> robots{1, 2};
  std::vector<Planner> planners{Planner::Wizard, Planner::Naive, Planner::Expert};
  double max_velocity_mps = 0.7;  ///< What is asked for, as in PlanRequest.
  double aggressiveness = 0.6;
  NamedText expert_alone;  ///< The expert's mission for one robot,
  NamedText expert_team;   ///< and for several.
  NamedText sentry;        ///< Mission of the enemy of several.
};

/// The building of a site: an office by chance that is come to from outside, by way points.
[[nodiscard]] NamedText study_site(std::uint64_t seed);

/// The same building for those who begin in its hallway.
[[nodiscard]] NamedText study_building(std::uint64_t seed);

/// What is asked for at a site: to go by the way points and the entry, then to search the building
/// for a biohazard; several robots are to expect an enemy in it. At the usual speed.
[[nodiscard]] PlanRequest study_request(const MapPlan& site, int robots);

/// One cell of a study's table of flights.
struct StudyFlight {
  int robots = 1;
  Planner planner = Planner::Wizard;
  Flight flight;        ///< Its seed is the site's.
  std::string refusal;  ///< Why there was nothing to fly; empty when it flew.

  /// The share of sub-tasks done; 0 when there was nothing to fly.
  [[nodiscard]] double score() const { return refusal.empty() ? flight.list.score() : 0.0; }
  [[nodiscard]] bool full() const { return refusal.empty() && flight.full(); }
};

/// One of them. Nothing when told to stop before its end.
[[nodiscard]] std::optional<StudyFlight> study_flight(const WizardStudy& study, StudyFlight which,
                                                      cbr::CaseShelf& cases,
                                                      const std::stop_token& stop);

/// All of them, site by site, on several threads; those that were finished when `stop` was asked
/// for. Throws ConfigError when the study makes no sense.
[[nodiscard]] std::vector<StudyFlight> study_flights(const WizardStudy& study,
                                                     cbr::CaseShelf& cases,
                                                     const CrewOptions& options,
                                                     const std::stop_token& stop);

}  // namespace tacit
