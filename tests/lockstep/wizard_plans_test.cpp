// Plans that the wizard makes, carried out as they come.

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <variant>
#include <vector>

#include "idl/overlay/office.h"
#include "idl/overlay/writer.h"
#include "tests/cbr/shelf.h"
#include "tests/lockstep/operations.h"
#include "wizard_service/cbr/wizard.h"

namespace tacit {
namespace {

using testing::carry_out;
using testing::Outcome;

/// What a person asks for: the points on the way, then the building.
PlanRequest request_for(const MapPlan& plan, int robots) {
  PlanRequest request;
  request.robots = robots;
  request.enemy = robots > 1;
  const MapPoint& shift = plan.ground.shift_m;
  for (const PlanPoint& point : plan.points) {
    if (!point.name.starts_with("Way") && point.name != "Entry") continue;
    request.tasks.push_back(
        {Task::Waypoints, point.at.x_m - shift.x_m, point.at.y_m - shift.y_m, {}, {}, false});
  }
  const MapPoint& hall = plan.halls.front().centre_line.front();
  request.tasks.push_back(
      {Task::Biohazard, hall.x_m - shift.x_m + 3.0, hall.y_m - shift.y_m, {}, {}, {}});
  request.max_velocity_mps = 0.7;
  request.aggressiveness = 0.6;
  return request;
}

/// The wizard's best plan.
std::string planned(const std::string& map, const PlanRequest& request) {
  cbr::testing::Shelf shelf;
  const cbr::Terrain terrain(read_overlay(map).map);
  return cbr::answer(request, terrain, shelf.index(), shelf).proposals.at(0).offered.mission;
}

Outcome flown(const std::string& map, int robots, bool naive, std::uint64_t seed) {
  PlanRequest request = request_for(plan_of(read_overlay(map).map, Doors::Open), robots);
  request.naive = naive;
  OperationWish wish;
  wish.mission = {planned(map, request), "plan"};
  wish.map = {map, "map"};
  if (robots > 1) wish.extras = testing::shipped_mission("sentry");
  return carry_out(wish, seed);
}

std::string site(std::uint64_t seed) { return to_text(random_office(seed, {.approach = true})); }

TEST(WizardPlans, OneRobotGoesByTheWayPointsAndFindsTheBiohazard) {
  const Outcome outcome = flown(site(1), 1, false, 1);
  EXPECT_EQ(outcome.list.done(), outcome.list.wanted()) << outcome.told();
}

TEST(WizardPlans, TwoRobotsDoSoUnderASentrysEyes) {
  const Outcome outcome = flown(site(1), 2, false, 1);
  EXPECT_EQ(outcome.list.done(), outcome.list.wanted()) << outcome.told();
}

double mean_score(int robots, bool naive, int sites) {
  double score = 0.0;
  for (int seed = 1; seed <= sites; ++seed) {
    const auto number = static_cast<std::uint64_t>(seed);
    score += flown(site(number), robots, naive, number).list.score();
  }
  return score / sites;
}

TEST(WizardPlans, OneRobotDoesNearlyAllInBuildingsDrawnByChance) {
  EXPECT_GE(mean_score(1, false, 100), 0.95);
}

TEST(WizardPlans, TwoRobotsDoMostInBuildingsDrawnByChance) {
  EXPECT_GE(mean_score(2, false, 60), 0.9);
}

TEST(WizardPlans, WithoutTheWizardLittleGetsDoneAndLessByTwo) {
  const double one = mean_score(1, true, 30);
  EXPECT_LT(one, 0.5);
  EXPECT_LT(mean_score(2, true, 30), one);
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
