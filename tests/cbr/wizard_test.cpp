#include "wizard_service/cbr/wizard.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "idl/cdl/check.h"
#include "idl/overlay/office.h"
#include "idl/overlay/reader.h"
#include "idl/types/config_error.h"
#include "tests/cbr/shelf.h"
#include "wizard_service/cbr/automaton.h"
#include "wizard_service/cbr/places.h"
#include "wizard_service/cbr/plan_cdl.h"
#include "wizard_service/cbr/sites.h"

namespace tacit::cbr {
namespace {

using testing::Shelf;
using testing::source_text;

Terrain office() { return Terrain(read_overlay(source_text("deploy/maps/office.ovl")).map); }

PlanRequest request(std::vector<PlacedTask> tasks, int robots, bool enemy) {
  PlanRequest request;
  request.tasks = std::move(tasks);
  request.robots = robots;
  request.enemy = enemy;
  return request;
}

PlacedTask placed(Task task, double x_m, double y_m) { return {task, x_m, y_m, {}, {}, {}}; }

Answer asked(const PlanRequest& wanted) {
  Shelf shelf;
  return answer(wanted, office(), shelf.index(), shelf);
}

/// The file of the first case of the best plan.
std::string first_case(const Answer& answer) {
  return Shelf().find(answer.proposals.at(0).offered.cases.at(0).id).origin;
}

bool tells(const Proposal& proposal, std::string_view rule) {
  const auto& changes = proposal.offered.changes;
  return std::any_of(changes.begin(), changes.end(),
                     [&](const PlanChange& one) { return one.rule == rule; });
}

TEST(Wizard, OffersThePlanOfTheBestCaseFirst) {
  const Answer alone = asked(request({placed(Task::Biohazard, 20, 22)}, 1, false));
  ASSERT_FALSE(alone.proposals.empty());
  EXPECT_EQ(first_case(alone), "biohazard_1");
  EXPECT_EQ(alone.proposals[0].offered.stars, 5.0);
  const Answer pair = asked(request({placed(Task::Biohazard, 20, 22)}, 2, true));
  EXPECT_EQ(first_case(pair), "biohazard_2_enemy");
  EXPECT_EQ(pair.proposals[0].plan.robots.size(), 2U);
}

TEST(Wizard, OffersMissionsWithoutErrors) {
  for (const int robots : {1, 2, 3, 10}) {
    for (const bool enemy : {false, true}) {
      const Answer answer =
          asked(request({placed(Task::Biohazard, 20, 22), placed(Task::ExplosiveOrdnance, 41, 10)},
                        robots, enemy));
      for (const Proposal& one : answer.proposals) {
        EXPECT_FALSE(cdl::has_error(cdl::check_text(one.offered.mission))) << one.offered.mission;
        EXPECT_EQ(one.plan.robots.size(), static_cast<std::size_t>(robots));
      }
    }
  }
}

TEST(Wizard, MovesATaskThatLiesInNoBuildingIntoOne) {
  const Answer answer = asked(request({placed(Task::Biohazard, 12, 8)}, 1, false));
  EXPECT_TRUE(tells(answer.proposals[0], "no-building"));
}

TEST(Wizard, TellsThatNobodyCoversOneRobot) {
  const Answer answer = asked(request({placed(Task::Biohazard, 20, 22)}, 1, true));
  EXPECT_TRUE(tells(answer.proposals[0], "no-cover"));
  EXPECT_LT(answer.proposals[0].offered.stars, 5.0);
}

TEST(Wizard, FindsThePlacesOfACaseThatBringsSomethingOut) {
  const Terrain terrain(read_overlay(source_text("deploy/maps/rescue.ovl")).map);
  Shelf shelf;
  const Answer answer = cbr::answer(request({placed(Task::SearchAndRescue, 27, 30)}, 1, false),
                                    terrain, shelf.index(), shelf);
  EXPECT_TRUE(tells(answer.proposals[0], "place"));
  const std::string& mission = answer.proposals[0].offered.mission;
  EXPECT_EQ(mission.find("{Begin}"), std::string::npos) << mission;
  EXPECT_EQ(mission.find("{Outside}"), std::string::npos) << mission;
}

/// A way point at the hallway's west end, then the building.
PlanRequest search_by_way_of_a_point(int robots, bool enemy) {
  PlanRequest wanted =
      request({placed(Task::Waypoints, 6, 22), placed(Task::Biohazard, 20, 22)}, robots, enemy);
  wanted.tasks.front().handles_enemy = false;
  return wanted;
}

const PlanState* labelled(const RobotPlan& robot, std::string_view label) {
  const auto found = std::find_if(robot.states.begin(), robot.states.end(),
                                  [&](const PlanState& one) { return one.label == label; });
  return found == robot.states.end() ? nullptr : &*found;
}

TEST(Wizard, LooksOutOnTheWayToWhereItsRobotsWarnEachOther) {
  const Answer pair = asked(search_by_way_of_a_point(2, true));
  ASSERT_EQ(pair.proposals[0].plan.robots.size(), 2U);
  EXPECT_TRUE(tells(pair.proposals[0], "watch"));
  for (const RobotPlan& robot : pair.proposals[0].plan.robots) {
    for (const char* label : {"Way to 1, enemy found", "Way to 2, enemy found"}) {
      const PlanState* state = labelled(robot, label);
      ASSERT_NE(state, nullptr) << robot.name << ' ' << label;
      EXPECT_EQ(*parameter(state->behaviour, "notify_message"), "\"Enemy found.\"");
    }
  }
}

TEST(Wizard, DoesNotLookOutWhereNobodyWarns) {
  for (const auto& [robots, enemy] : {std::pair(1, true), std::pair(2, false)}) {
    EXPECT_FALSE(tells(asked(search_by_way_of_a_point(robots, enemy)).proposals[0], "watch"));
  }
}

TEST(Wizard, LetsWhoHasBeenWarnedBeginWithWhatItDoesAboutAnEnemy) {
  const Answer pair = asked(search_by_way_of_a_point(2, true));
  const RobotPlan& cover = pair.proposals[0].plan.robots[1];
  const PlanState* warned = labelled(cover, "Way to 2, warned");
  ASSERT_NE(warned, nullptr);
  EXPECT_EQ(find_state(cover, warned->rules.back().target)->label, "EnemyFound");
  const PlanState* first = labelled(cover, "BiohazardTask 2");
  ASSERT_NE(first, nullptr);
  EXPECT_EQ(find_state(cover, first->rules.back().target)->label, "Follow");
}

TEST(Wizard, BeginsInABuildingWithTheWholeSquadInside) {
  const Terrain terrain(random_office(1, {.approach = true}));
  const PlanRequest wanted = request({placed(Task::Biohazard, 20, 8)}, 1, false);
  Changes changes;
  const auto begin = [&](int robots) {
    return place_tasks(wanted, {robots, {0}}, terrain, changes).front().at;
  };
  EXPECT_NEAR(distance(begin(1), begin(2)), kSpacing, 0.2);
  EXPECT_LT(distance(begin(1), begin(10)), 3.0);
}

TEST(Wizard, RefusesATaskOutsideTheMap) {
  EXPECT_THROW((void)asked(request({placed(Task::Biohazard, 100, 22)}, 1, false)), ConfigError);
}

TEST(Wizard, RefusesAnEmptyRequestAndTooManyRobots) {
  EXPECT_THROW((void)asked(request({}, 1, false)), ConfigError);
  EXPECT_THROW((void)asked(request({placed(Task::Biohazard, 20, 22)}, 1000, false)), ConfigError);
}

TEST(Wizard, RefusesATaskThatNoCaseIsFor) {
  Shelf shelf("waypoints");
  EXPECT_THROW((void)answer(request({placed(Task::SearchAndRescue, 20, 22)}, 1, false), office(),
                            shelf.index(), shelf),
               ConfigError);
}

TEST(Wizard, DrawsAStraightWayWhenItIsLeftOut) {
  PlanRequest naive = request({placed(Task::Biohazard, 20, 22)}, 2, false);
  naive.naive = true;
  const Answer answer = asked(naive);
  ASSERT_EQ(answer.proposals.size(), 1U);
  EXPECT_EQ(answer.proposals[0].plan.robots.size(), 2U);
  EXPECT_FALSE(cdl::has_error(cdl::check_text(answer.proposals[0].offered.mission)));
}

TEST(Terrain, LeadsRoundWallsThroughDoors) {
  const Terrain terrain = office();
  const MapPoint library{26, 14};
  EXPECT_TRUE(terrain.is_reachable(library));
  EXPECT_GE(terrain.route({4, 22}, library).size(), 2U);
  const MapPoint store{16, 15};  // It has no door.
  EXPECT_TRUE(terrain.is_free(store));
  EXPECT_FALSE(terrain.is_reachable(store));
  EXPECT_TRUE(terrain.route({4, 22}, store).empty());
}

}  // namespace
}  // namespace tacit::cbr
