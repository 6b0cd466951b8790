#include "deploy/experiment/wizard_study.h"

#include <algorithm>
#include <utility>

#include "deploy/lockstep/operation_setup.h"
#include "idl/overlay/office.h"
#include "idl/overlay/reader.h"
#include "idl/overlay/writer.h"
#include "idl/types/config_error.h"
#include "wizard_service/cbr/terrain.h"
#include "wizard_service/cbr/wizard.h"

namespace tacit {
namespace {

void refuse_mistakes(const WizardStudy& study) {
  if (study.sites < 1 || study.sites > kMostSites) {
    throw ConfigError("a study: found " + std::to_string(study.sites) + " sites, wanted 1 to " +
                      std::to_string(kMostSites));
  }
  if (study.robots.empty() || study.planners.empty()) {
    throw ConfigError("a study: found no number of robots or no planner, wanted one of each");
  }
  for (const int robots : study.robots) {
    if (robots >= 1 && robots <= kMostPlannedRobots) continue;
    throw ConfigError("a study: found " + std::to_string(robots) + " robots, wanted 1 to " +
                      std::to_string(kMostPlannedRobots));
  }
}

NamedText office(std::uint64_t seed, bool approach) {
  OfficeConfig config;
  config.approach = approach;
  return {to_text(random_office(seed, config)), "site " + std::to_string(seed)};
}

std::string planned(const WizardStudy& study, const NamedText& map, const StudyFlight& which,
                    cbr::CaseShelf& cases) {
  const cbr::Terrain terrain(read_overlay(map.text).map);
  PlanRequest request = study_request(terrain.plan(), which.robots);
  request.max_velocity_mps = study.max_velocity_mps;
  request.aggressiveness = study.aggressiveness;
  request.naive = which.planner == Planner::Naive;
  return cbr::answer(request, terrain, cases.index(), cases).proposals.at(0).offered.mission;
}

OperationWish operation(const WizardStudy& study, const StudyFlight& which, cbr::CaseShelf& cases) {
  OperationWish wish;
  if (which.planner == Planner::Expert) {
    wish.map = study_building(which.flight.seed);
    wish.mission = which.robots > 1 ? study.expert_team : study.expert_alone;
    wish.robots = static_cast<std::size_t>(which.robots);
  } else {
    wish.map = study_site(which.flight.seed);
    wish.mission = {planned(study, wish.map, which, cases), "plan"};
  }
  if (which.robots > 1) wish.extras = study.sentry;
  return wish;
}

std::vector<StudyFlight> cells_of(const WizardStudy& study) {
  std::vector<StudyFlight> cells;
  for (std::size_t i = 0; i < study.sites; ++i) {
    for (const int robots : study.robots) {
      for (const Planner planner : study.planners) {
        StudyFlight cell{robots, planner, {}, {}};
        cell.flight.seed = study.first + i;
        cells.push_back(std::move(cell));
      }
    }
  }
  return cells;
}

}  // namespace

const char* word(Planner planner) {
  switch (planner) {
    case Planner::Wizard:
      return "wizard";
    case Planner::Naive:
      return "naive";
    case Planner::Expert:
      return "expert";
  }
  return "";
}

NamedText study_site(std::uint64_t seed) { return office(seed, true); }

NamedText study_building(std::uint64_t seed) { return office(seed, false); }

PlanRequest study_request(const MapPlan& site, int robots) {
  constexpr double kInside_m = 3.0;
  PlanRequest request;
  request.robots = robots;
  request.enemy = robots > 1;
  const MapPoint& shift = site.ground.shift_m;
  const auto add = [&](Task task, const MapPoint& at, std::optional<bool> enemy) {
    request.tasks.push_back({task, at.x_m - shift.x_m, at.y_m - shift.y_m, {}, {}, enemy});
  };
  for (const PlanPoint& point : site.points) {
    const bool on_the_way = point.name.starts_with("Way") || point.name == "Entry";
    if (on_the_way) add(Task::Waypoints, point.at, false);
  }
  const MapPoint& hall = site.halls.front().centre_line.front();
  add(Task::Biohazard, {hall.x_m + kInside_m, hall.y_m}, std::nullopt);
  return request;
}

std::optional<StudyFlight> study_flight(const WizardStudy& study, StudyFlight which,
                                        cbr::CaseShelf& cases, const std::stop_token& stop) {
  const std::uint64_t seed = which.flight.seed;
  try {
    std::optional<Flight> flight = fly(operation_setup(operation(study, which, cases)), seed, stop);
    if (!flight) return std::nullopt;
    which.flight = std::move(*flight);
  } catch (const ConfigError& error) {
    which.refusal = error.what();
  }
  return which;
}

std::vector<StudyFlight> study_flights(const WizardStudy& study, cbr::CaseShelf& cases,
                                       const CrewOptions& options, const std::stop_token& stop) {
  refuse_mistakes(study);
  const std::vector<StudyFlight> cells = cells_of(study);
  std::vector<StudyFlight> flights;
  for (std::optional<StudyFlight>& flight :
       made_by_crew(cells.size(), options, stop,
                    [&](std::size_t i) { return study_flight(study, cells[i], cases, stop); })) {
    if (flight) flights.push_back(std::move(*flight));
  }
  return flights;
}

}  // namespace tacit
