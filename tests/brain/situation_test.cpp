#include "robot_agent/brain/perception/situation.h"

#include <gtest/gtest.h>

#include "robot_agent/brain/perception/perception.h"
#include "tests/brain/percepts.h"

namespace tacit {
namespace {

using testing::disabled;
using testing::enemy;
using testing::percept;
using testing::target;
using testing::teammate;

Situation judged(const std::vector<Sighting>& sightings) {
  const Occlusion occlusion{Occlusion::Config{}};
  Perception perception(EnemyGroups(EnemyGroups::Config{}), occlusion, Attention::Everything);
  const Percept now = percept(1, sightings);
  return situation(perception.look(now), occlusion, SituationConfig{});
}

TEST(Situation, IsAllClearWithoutVisibleEnemies) {
  EXPECT_EQ(judged({target(10, 0), teammate(5, 5)}), Situation::AllClear);
}

TEST(Situation, IsClearToEnemyBetweenTargetAndAnOpenGroup) {
  EXPECT_EQ(judged({target(-10, 0), enemy(30, 0)}), Situation::ClearToEnemy);
}

TEST(Situation, IsFlankingEnemyBesideAnOpenGroup) {
  EXPECT_EQ(judged({target(10, 0), enemy(30, 0)}), Situation::FlankingEnemy);
}

TEST(Situation, IsFlankingEnemyWhileTheTargetWasNeverSeen) {
  EXPECT_EQ(judged({enemy(30, 0)}), Situation::FlankingEnemy);
}

TEST(Situation, IsSoldierNeedsHelpWhenOneOfTheInterceptedGroupsIsTooLarge) {
  EXPECT_EQ(judged({enemy(30, 0), enemy(31, 0), enemy(32, 0), teammate(20, 0),  // 1 against 3
                    enemy(-30, 0), teammate(-20, 0)}),                          // 1 against 1
            Situation::SoldierNeedsHelp);
}

TEST(Situation, IsNoSoldiersNeedHelpWhenAllGroupsAreInterceptedByEnough) {
  EXPECT_EQ(judged({enemy(30, 0), teammate(20, 0), enemy(-30, 0), teammate(-20, 0)}),
            Situation::NoSoldiersNeedHelp);
}

TEST(Situation, GoesByTheNearestOpenGroupNotByANearerOccludedOne) {
  EXPECT_EQ(judged({target(-10, 0), enemy(0, -20), teammate(0, -10), enemy(30, 0)}),
            Situation::ClearToEnemy);
}

TEST(Situation, GoesByTheNearestOfTheOpenGroups) {
  EXPECT_EQ(judged({target(-10, 0), enemy(60, 0), enemy(0, 30)}), Situation::FlankingEnemy);
}

TEST(Situation, TakesADisabledTeammateForNoInterceptor) {
  EXPECT_EQ(judged({target(-10, 0), enemy(30, 0), disabled(20, 0)}), Situation::ClearToEnemy);
}

TEST(Situation, HasThePapersNames) {
  EXPECT_EQ(name(Situation::AllClear), "AllClear");
  EXPECT_EQ(name(Situation::ClearToEnemy), "ClearToEnemy");
  EXPECT_EQ(name(Situation::FlankingEnemy), "FlankingEnemy");
  EXPECT_EQ(name(Situation::SoldierNeedsHelp), "SoldierNeedsHelp");
  EXPECT_EQ(name(Situation::NoSoldiersNeedHelp), "NoSoldiersNeedHelp");
}

TEST(Overwhelmed, MeansFewerThanHalfASoldierPerEnemy) {
  EXPECT_TRUE(overwhelmed(1, 3, 0.5));
  EXPECT_FALSE(overwhelmed(1, 2, 0.5));
  EXPECT_FALSE(overwhelmed(2, 3, 0.5));
}

TEST(Between, HoldsUpToTheLateralBorder) {
  EXPECT_TRUE(between({-10.0, 6.0}, {30.0, 6.0}, 6.0));
  EXPECT_FALSE(between({-10.0, 6.001}, {30.0, 6.001}, 6.0));
  EXPECT_TRUE(between({-10.0, -6.0}, {30.0, -6.0}, 6.0));
  EXPECT_FALSE(between({-10.0, -6.001}, {30.0, -6.001}, 6.0));
}

TEST(Between, EndsWhereTheProjectionLeavesTheSegment) {
  EXPECT_TRUE(between({0.0, 3.0}, {30.0, 3.0}, 6.0));
  EXPECT_FALSE(between({0.001, 3.0}, {30.0, 3.0}, 6.0));
  EXPECT_TRUE(between({-30.0, 3.0}, {0.0, 3.0}, 6.0));
  EXPECT_FALSE(between({-30.0, 3.0}, {-0.001, 3.0}, 6.0));
}

TEST(Between, IsFalseForAGroupAtTheTarget) { EXPECT_FALSE(between({0, 0}, {0, 0}, 6.0)); }

}  // namespace
}  // namespace tacit
