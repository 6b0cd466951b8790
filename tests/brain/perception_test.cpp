#include "robot_agent/brain/perception/perception.h"

#include <gtest/gtest.h>

#include "tests/brain/percepts.h"

namespace tacit {
namespace {

using testing::disabled;
using testing::enemy;
using testing::percept;
using testing::target;
using testing::teammate;

Perception perception(Attention attention) {
  return {EnemyGroups(EnemyGroups::Config{}), Occlusion(Occlusion::Config{}), attention};
}

TEST(Perception, SortsSightingsByKindAndMeasuresThem) {
  Perception eyes = perception(Attention::Everything);
  const Percept now = percept(1, {teammate(3, 4), enemy(6, 8), target(1, 2), disabled(0, 7)});

  const Surroundings& around = eyes.look(now);

  ASSERT_EQ(around.teammates.size(), 2U);
  EXPECT_DOUBLE_EQ(around.teammates[0].range_m, 5.0);
  EXPECT_TRUE(around.teammates[0].able);
  EXPECT_FALSE(around.teammates[1].able);
  ASSERT_EQ(around.enemies.size(), 1U);
  EXPECT_DOUBLE_EQ(around.enemies[0].range_m, 10.0);
  EXPECT_EQ(around.groups.size(), 1U);
}

TEST(Perception, ForgetsTheSightingsOfTheTickBefore) {
  Perception eyes = perception(Attention::Everything);
  const Percept before = percept(1, {teammate(3, 4), enemy(6, 8)});
  const Percept now = percept(2, {});
  static_cast<void>(eyes.look(before));

  const Surroundings& around = eyes.look(now);

  EXPECT_TRUE(around.teammates.empty());
  EXPECT_TRUE(around.enemies.empty());
  EXPECT_TRUE(around.groups.empty());
  EXPECT_EQ(around.open_group, nullptr);
}

TEST(Perception, LeavesEnemiesOutWhenTheyAreOfNoUse) {
  Perception eyes = perception(Attention::NoEnemies);
  const Percept now = percept(1, {enemy(6, 8)});

  EXPECT_TRUE(eyes.look(now).groups.empty());
}

TEST(Perception, PrefersTheNearestOpenGroupToANearerOccludedOne) {
  Perception eyes = perception(Attention::Everything);
  const Percept now = percept(1, {enemy(20, 0), teammate(10, 0), enemy(0, 40), enemy(0, -60)});

  const Surroundings& around = eyes.look(now);

  ASSERT_NE(around.open_group, nullptr);
  EXPECT_EQ(around.open_group->centroid_m, BodyVec(0, 40));
}

TEST(Perception, KnowsNoTargetBeforeItWasSeen) {
  Perception eyes = perception(Attention::Everything);
  const Percept now = percept(1, {});

  EXPECT_FALSE(eyes.look(now).target_m.has_value());
}

TEST(Perception, RemembersTheTargetThroughTheRobotsOwnMotion) {
  Perception eyes = perception(Attention::Everything);
  const Percept before = percept(1, {target(10, 0)});
  Percept now = percept(2, {});
  now.odometry = {{10.0, 5.0}, {0.0, 1.0}};  // Moved, and turned a quarter to the left.
  static_cast<void>(eyes.look(before));

  const Surroundings& around = eyes.look(now);

  ASSERT_TRUE(around.target_m.has_value());
  EXPECT_NEAR(around.target_m->x(), -5.0, 1e-12);
  EXPECT_NEAR(around.target_m->y(), 0.0, 1e-12);
}

}  // namespace
}  // namespace tacit
