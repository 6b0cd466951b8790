// The missions that ship, carried out on the maps that ship and in buildings drawn by chance.

#include <gtest/gtest.h>

#include <algorithm>

#include "idl/overlay/office.h"
#include "idl/overlay/writer.h"
#include "tests/lockstep/operations.h"

namespace tacit {
namespace {

using testing::carry_out;
using testing::Outcome;
using testing::shipped_map;
using testing::shipped_mission;

OperationWish wish(const std::string& mission, const NamedText& map, bool sentry = false) {
  OperationWish wish;
  wish.mission = shipped_mission(mission);
  wish.map = map;
  if (sentry) wish.extras = shipped_mission("sentry");
  return wish;
}

NamedText office(std::uint64_t seed) {
  return {to_text(random_office(seed, {})), "office " + std::to_string(seed)};
}

TEST(OwnMissions, OneRobotFindsTheBiohazardInTheOffice) {
  const Outcome outcome = carry_out(wish("biohazard", shipped_map("office")), 1);
  EXPECT_TRUE(outcome.over);
  EXPECT_GT(outcome.list.wanted(), 3U);
  EXPECT_EQ(outcome.list.done(), outcome.list.wanted()) << outcome.told();
}

TEST(OwnMissions, TwoRobotsFindItUnderASentrysEyes) {
  const Outcome outcome = carry_out(wish("biohazard_pair", shipped_map("office"), true), 1);
  EXPECT_TRUE(outcome.over);
  EXPECT_GT(outcome.list.wanted(), 5U);
  EXPECT_EQ(outcome.list.done(), outcome.list.wanted()) << outcome.told();
}

TEST(OwnMissions, EveryMineGoesToTheAreaForExplosiveOrdnance) {
  const Outcome outcome = carry_out(wish("eod", shipped_map("minefield")), 1);
  EXPECT_TRUE(outcome.over);
  EXPECT_GE(outcome.list.wanted(), 7U);
  EXPECT_EQ(outcome.list.done(), outcome.list.wanted()) << outcome.told();
}

TEST(OwnMissions, TheScoutGoesByEveryWayPoint) {
  const Outcome outcome = carry_out(wish("waypoints", shipped_map("waypoints")), 1);
  EXPECT_TRUE(outcome.over);
  EXPECT_GE(outcome.list.wanted(), 7U);
  EXPECT_EQ(outcome.list.done(), outcome.list.wanted()) << outcome.told();
}

TEST(OwnMissions, EverybodyInTheDamagedBuildingIsBroughtToFirstAid) {
  const Outcome outcome = carry_out(wish("rescue", shipped_map("rescue")), 1);
  EXPECT_TRUE(outcome.over);
  EXPECT_EQ(outcome.list.done(), outcome.list.wanted()) << outcome.told();
  EXPECT_EQ(std::count_if(outcome.events.begin(), outcome.events.end(),
                          [](const Event& event) {
                            return std::holds_alternative<ObjectStored>(event.what);
                          }),
            3);
}

TEST(OwnMissions, TheHostageIsFoundAndNotLeftAlone) {
  const Outcome outcome = carry_out(wish("hostage", shipped_map("hostage")), 1);
  EXPECT_TRUE(outcome.over);
  EXPECT_EQ(outcome.list.done(), outcome.list.wanted()) << outcome.told();
}

TEST(OwnMissions, OneRobotFindsTheBiohazardInBuildingsDrawnByChance) {
  double score = 0.0;
  constexpr int kBuildings = 200;
  for (int seed = 1; seed <= kBuildings; ++seed) {
    const auto number = static_cast<std::uint64_t>(seed);
    score += carry_out(wish("biohazard", office(number)), number).list.score();
  }
  EXPECT_GE(score / kBuildings, 0.95);
}

// A hiding game that may go on for an hour is cut short here; a battery of 200 whole ones is in
// docs/results.md.
TEST(OwnMissions, TwoRobotsDoMostOfTheirSubTasksInBuildingsDrawnByChance) {
  double score = 0.0;
  constexpr int kBuildings = 30;
  for (int seed = 1; seed <= kBuildings; ++seed) {
    const auto number = static_cast<std::uint64_t>(seed);
    score += carry_out(wish("biohazard_pair", office(number), true), number).list.score();
  }
  EXPECT_GE(score / kBuildings, 0.9);
}

TEST(OwnMissions, MoreRobotsPlayTheLastOnesPart) {
  OperationWish three = wish("eod", shipped_map("minefield"));
  three.robots = 3;
  const Outcome outcome = carry_out(three, 1);
  EXPECT_TRUE(outcome.over);
  EXPECT_EQ(outcome.list.done(), outcome.list.wanted()) << outcome.told();
  EXPECT_LT(outcome.ticks, carry_out(wish("eod", shipped_map("minefield")), 1).ticks);
}

std::vector<Event> foraged(const std::string& roles, const char* learner) {
  Setup setup = setup_for(MissionKind::Forage);
  setup.world.robots.count = 5;
  setup.world.forage.mud.per_tick = 0.0005;
  setup.world.forage.hunters.min_wait_ticks = 50;
  setup.world.forage.hunters.max_wait_ticks = 200;
  setup.brain.learner = learner;
  setup.brain.roles.mission = roles;
  Team team(setup.world, setup.brain, 3);
  std::vector<Event> events;
  while (!team.done(6000)) {
    const auto more = team.step();
    events.insert(events.end(), more.begin(), more.end());
  }
  return events;
}

TEST(OwnMissions, TheRolesOfAForagingTeamDoWhatTheBuiltInOnesDo) {
  const std::string roles = shipped_mission("roles").text;
  for (const char* learner : {"q", "homogeneous", "heterogeneous"}) {
    const std::vector<Event> built_in = foraged("", learner);
    EXPECT_GT(built_in.size(), 50U);
    EXPECT_EQ(foraged(roles, learner), built_in) << learner;
  }
}

}  // namespace
}  // namespace tacit
