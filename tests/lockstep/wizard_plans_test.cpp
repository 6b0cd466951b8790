// Plans that the wizard makes, carried out as they come.

#include <gtest/gtest.h>

#include <string>
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

Outcome flown(const std::string& map, int robots, bool naive, std::uint64_t seed) {
  cbr::testing::Shelf shelf;
  const cbr::Terrain terrain(read_overlay(map).map);
  PlanRequest request = request_for(terrain.plan(), robots);
  request.naive = naive;
  const cbr::Answer answer = cbr::answer(request, terrain, shelf.index(), shelf);
  OperationWish wish;
  wish.mission = {answer.proposals.at(0).offered.mission, "plan"};
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

}  // namespace
}  // namespace tacit
