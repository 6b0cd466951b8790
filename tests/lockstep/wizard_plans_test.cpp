// Plans that the wizard makes, carried out as they come.

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <variant>
#include <vector>

#include "deploy/experiment/wizard_study.h"
#include "idl/overlay/reader.h"
#include "tests/cbr/shelf.h"
#include "tests/lockstep/operations.h"
#include "wizard_service/cbr/wizard.h"

namespace tacit {
namespace {

using testing::carry_out;
using testing::Outcome;

/// How a person wants robots to go.
struct Pace {
  double max_mps = 0.5;
  double aggressiveness = 0.3;
};
/// As it is unless somebody says otherwise: 0.15 m/s as a rule.
constexpr Pace kUsual{};
constexpr Pace kFast{0.7, 0.6};

/// What a person asks for: the points on the way, then the building.
PlanRequest request_for(const std::string& map, int robots, const Pace& pace) {
  PlanRequest request = study_request(plan_of(read_overlay(map).map, Doors::Open), robots);
  request.max_velocity_mps = pace.max_mps;
  request.aggressiveness = pace.aggressiveness;
  return request;
}

/// The wizard's best plan.
std::string planned(const std::string& map, const PlanRequest& request) {
  cbr::testing::Shelf shelf;
  const cbr::Terrain terrain(read_overlay(map).map);
  return cbr::answer(request, terrain, shelf.index(), shelf).proposals.at(0).offered.mission;
}

/// A mission on a map, under a sentry's eyes when it is for two robots.
Outcome carried_out(const NamedText& mission, const std::string& map, int robots,
                    std::uint64_t seed) {
  OperationWish wish;
  wish.mission = mission;
  wish.map = {map, "map"};
  if (robots > 1) wish.extras = testing::shipped_mission("sentry");
  return carry_out(wish, seed);
}

Outcome of_the_wizard(const PlanRequest& request, const std::string& map, std::uint64_t seed) {
  return carried_out({planned(map, request), "plan"}, map, *request.robots, seed);
}

Outcome of_the_expert(const std::string& map, int robots, std::uint64_t seed) {
  return carried_out(testing::shipped_mission(robots > 1 ? "biohazard_pair" : "biohazard"), map,
                     robots, seed);
}

std::string building(std::uint64_t seed, bool approach) {
  return (approach ? study_site(seed) : study_building(seed)).text;
}

TEST(WizardPlans, OneRobotGoesByTheWayPointsAndFindsTheBiohazard) {
  const std::string map = building(1, true);
  const Outcome outcome = of_the_wizard(request_for(map, 1, kFast), map, 1);
  EXPECT_EQ(outcome.list.done(), outcome.list.wanted()) << outcome.told();
}

TEST(WizardPlans, TwoRobotsDoSoUnderASentrysEyes) {
  const std::string map = building(1, true);
  const Outcome outcome = of_the_wizard(request_for(map, 2, kFast), map, 1);
  EXPECT_EQ(outcome.list.done(), outcome.list.wanted()) << outcome.told();
}

/// What became of many plans.
struct Tally {
  double mean = 0.0;    ///< Of their scores.
  double nearly = 0.0;  ///< The share of those that did 90 % of their sub-tasks.
};

/// `run` tells the outcome for a seed.
template <class Run>
Tally tally(int sites, const Run& run) {
  Tally all;
  for (int seed = 1; seed <= sites; ++seed) {
    const double score = run(static_cast<std::uint64_t>(seed)).list.score();
    all.mean += score / sites;
    all.nearly += score >= 0.9 ? 1.0 / sites : 0.0;
  }
  return all;
}

Tally over_sites(int sites, int robots, const Pace& pace, bool naive = false) {
  return tally(sites, [&](std::uint64_t seed) {
    const std::string map = building(seed, true);
    PlanRequest request = request_for(map, robots, pace);
    request.naive = naive;
    return of_the_wizard(request, map, seed);
  });
}

TEST(WizardPlans, OneRobotDoesAllInBuildingsDrawnByChance) {
  EXPECT_GT(over_sites(50, 1, kFast).mean, 0.999);
  EXPECT_GT(over_sites(50, 1, kUsual).mean, 0.999);
}

TEST(WizardPlans, TwoRobotsDoNearlyAllInBuildingsDrawnByChance) {
  const Tally all = over_sites(100, 2, kFast);
  EXPECT_GE(all.nearly, 0.98);
  EXPECT_GE(all.mean, 0.99);
}

// Slow ones are seen before the building, farther from a room than 40 s of their way.
TEST(WizardPlans, TwoSlowRobotsDoMostInBuildingsDrawnByChance) {
  const Tally all = over_sites(60, 2, kUsual);
  EXPECT_GE(all.nearly, 0.95);
  EXPECT_GE(all.mean, 0.92);
}

TEST(WizardPlans, WithoutTheWizardLittleGetsDoneAndLessByTwo) {
  const double one = over_sites(30, 1, kFast, true).mean;
  EXPECT_LT(one, 0.5);
  EXPECT_LT(over_sites(30, 2, kFast, true).mean, one);
}

TEST(WizardPlans, DoAsMuchAsTheExpertsMissionsInTheOffice) {
  const std::string map = testing::shipped_map("office").text;
  for (const int robots : {1, 2}) {
    const Outcome outcome = of_the_wizard(request_for(map, robots, kFast), map, 1);
    EXPECT_GE(outcome.list.score(), of_the_expert(map, robots, 1).list.score()) << outcome.told();
  }
}

TEST(WizardPlans, DoAsMuchAsTheExpertsMissionsInBuildingsDrawnByChance) {
  for (const int robots : {1, 2}) {
    const Tally wizard = tally(30, [&](std::uint64_t seed) {
      const std::string map = building(seed, false);
      return of_the_wizard(request_for(map, robots, kFast), map, seed);
    });
    const Tally expert = tally(
        30, [&](std::uint64_t seed) { return of_the_expert(building(seed, false), robots, seed); });
    EXPECT_GE(wizard.mean, expert.mean) << robots;
    EXPECT_GE(wizard.nearly, expert.nearly) << robots;
  }
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
