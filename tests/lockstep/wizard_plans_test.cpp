// Plans that the wizard makes, carried out as they come.

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <variant>
#include <vector>

#include "deploy/experiment/wizard_study.h"
#include "tests/cbr/shelf.h"
#include "tests/lockstep/operations.h"
#include "wizard_service/cbr/wizard.h"

namespace tacit {
namespace {

using testing::carry_out;
using testing::Outcome;

/// The wizard's best plan.
std::string planned(const std::string& map, const PlanRequest& request) {
  cbr::testing::Shelf shelf;
  const cbr::Terrain terrain(read_overlay(map).map);
  return cbr::answer(request, terrain, shelf.index(), shelf).proposals.at(0).offered.mission;
}

Flight flown(int robots, Planner planner, std::uint64_t site) {
  static cbr::CaseShelf cases(cbr::testing::Shelf().all());
  WizardStudy study;
  study.expert_alone = testing::shipped_mission("biohazard");
  study.expert_team = testing::shipped_mission("biohazard_pair");
  study.sentry = testing::shipped_mission("sentry");
  StudyFlight which{robots, planner, {}, {}};
  which.flight.seed = site;
  return study_flight(study, which, cases, {}).value().flight;
}

std::string told(const std::vector<std::string>& failures) {
  std::string text;
  for (const std::string& failure : failures) text += failure + '\n';
  return text;
}

TEST(WizardPlans, OneRobotGoesByTheWayPointsAndFindsTheBiohazard) {
  const Flight flight = flown(1, Planner::Wizard, 1);
  EXPECT_TRUE(flight.full()) << told(flight.failures());
}

TEST(WizardPlans, TwoRobotsDoSoUnderASentrysEyes) {
  const Flight flight = flown(2, Planner::Wizard, 1);
  EXPECT_TRUE(flight.full()) << told(flight.failures());
}

double mean_score(int robots, Planner planner, std::uint64_t sites) {
  double score = 0.0;
  for (std::uint64_t site = 1; site <= sites; ++site) {
    score += flown(robots, planner, site).list.score();
  }
  return score / static_cast<double>(sites);
}

TEST(WizardPlans, OneRobotDoesNearlyAllInBuildingsDrawnByChance) {
  EXPECT_GE(mean_score(1, Planner::Wizard, 100), 0.95);
}

TEST(WizardPlans, TwoRobotsDoMostInBuildingsDrawnByChance) {
  EXPECT_GE(mean_score(2, Planner::Wizard, 60), 0.9);
}

TEST(WizardPlans, WithoutTheWizardLittleGetsDoneAndLessByTwo) {
  const double one = mean_score(1, Planner::Naive, 30);
  EXPECT_LT(one, 0.5);
  EXPECT_LT(mean_score(2, Planner::Naive, 30), one);
}

/// A task on a map that ships, with points to go by before.
struct Errand {
  Task task = Task::Waypoints;
  const char* map = "";
  std::vector<MapPoint> way;
  MapPoint at;
};

const std::vector<Errand>& errands() {
  static const std::vector<Errand> kErrands{
      {Task::Biohazard, "office", {}, {20, 22}},
      {Task::ExplosiveOrdnance, "minefield", {}, {20, 14}},
      {Task::Waypoints, "waypoints", {{30, 18}, {48, 40}, {36, 66}, {64, 74}, {84, 52}}, {92, 48}},
      {Task::HostageMonitoring, "hostage", {{24, 30}, {42.5, 27}}, {57, 27}},
      {Task::SearchAndRescue, "rescue", {{27, 14.5}}, {27, 30}},
  };
  return kErrands;
}

Outcome run_errand(const Errand& errand, int robots, bool enemy) {
  PlanRequest request;
  for (const MapPoint& point : errand.way) {
    request.tasks.push_back({Task::Waypoints, point.x_m, point.y_m, {}, {}, {}});
  }
  request.tasks.push_back({errand.task, errand.at.x_m, errand.at.y_m, {}, {}, {}});
  request.robots = robots;
  request.enemy = enemy;
  const NamedText map = testing::shipped_map(errand.map);
  OperationWish wish;
  wish.mission = {planned(map.text, request), "plan"};
  wish.map = map;
  return carry_out(wish, 1);
}

template <class Kind>
std::ptrdiff_t count_of(const Outcome& outcome) {
  return std::count_if(outcome.events.begin(), outcome.events.end(),
                       [](const Event& event) { return std::holds_alternative<Kind>(event.what); });
}

TEST(WizardPlans, GetAllDoneForEveryTaskByOneRobotAndByTwo) {
  for (const Errand& errand : errands()) {
    for (const int robots : {1, 2}) {
      for (const bool enemy : {false, true}) {
        const Outcome outcome = run_errand(errand, robots, enemy);
        EXPECT_TRUE(outcome.over) << errand.map << ' ' << robots << enemy;
        EXPECT_GE(outcome.list.wanted(), 5U) << errand.map;
        EXPECT_EQ(outcome.list.done(), outcome.list.wanted())
            << errand.map << ' ' << robots << enemy << '\n'
            << outcome.told();
      }
    }
  }
}

TEST(WizardPlans, BringEverybodyToFirstAidAndTellOfTheHostage) {
  for (const int robots : {1, 2}) {
    for (const bool enemy : {false, true}) {
      EXPECT_EQ(count_of<ObjectStored>(run_errand(errands()[4], robots, enemy)), 3);
      EXPECT_EQ(count_of<Alerted>(run_errand(errands()[3], robots, enemy)), 1);
    }
  }
}

}  // namespace
}  // namespace tacit
