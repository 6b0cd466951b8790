#include "robot_agent/brain/perception/forage_perception.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/brain/forage_surroundings.h"

namespace tacit {
namespace {

using testing::base;
using testing::disabled;
using testing::enemy;
using testing::ForageEyes;
using testing::mine;
using testing::percept;
using testing::teammate;

TEST(ForagePerception, KnowsTheNearestOfEachClass) {
  ForageEyes eyes;
  const Surroundings& around = eyes.look({mine(5, 0), mine(0, 3), enemy(9, 9), enemy(1, 1),
                                          disabled(0, 7), base(2, 2), disabled(0, 6)});
  EXPECT_EQ(around.nearest_of(Thing::Mine).offset_m, BodyVec(0, 3));
  EXPECT_EQ(around.nearest_of(Thing::Enemy).offset_m, BodyVec(1, 1));
  EXPECT_EQ(around.nearest_of(Thing::Disabled).offset_m, BodyVec(0, 6));
  EXPECT_EQ(around.nearest_of(Thing::Base).offset_m, BodyVec(2, 2));
  EXPECT_DOUBLE_EQ(around.nearest_of(Thing::Base).squared_range_m2, 8.0);
}

TEST(ForagePerception, ForgetsWhatWasSeenTheTickBefore) {
  ForageEyes eyes;
  eyes.look({mine(5, 0), enemy(9, 9), disabled(0, 7), teammate(0.5, 0)});
  const Surroundings& around = eyes.look(std::vector<Sighting>{});
  EXPECT_FALSE(around.nearest_of(Thing::Mine).known());
  EXPECT_FALSE(around.nearest_of(Thing::Enemy).known());
  EXPECT_FALSE(around.nearest_of(Thing::Disabled).known());
  EXPECT_TRUE(around.teammates.empty());
}

TEST(ForagePerception, PicksTheSameOfTwoEquallyNearInAnyOrder) {
  ForageEyes eyes;
  const BodyVec once = eyes.look({mine(3, 4), mine(4, 3)}).nearest_of(Thing::Mine).offset_m;
  EXPECT_EQ(eyes.look({mine(4, 3), mine(3, 4)}).nearest_of(Thing::Mine).offset_m, once);
  const BodyVec level = eyes.look({mine(3, 4), mine(-3, 4)}).nearest_of(Thing::Mine).offset_m;
  EXPECT_EQ(eyes.look({mine(-3, 4), mine(3, 4)}).nearest_of(Thing::Mine).offset_m, level);
}

TEST(ForagePerception, KeepsAbleTeammatesInReachToAvoid) {
  ForageEyes eyes;
  const Surroundings& around = eyes.look({teammate(0.6, 0.8), teammate(1.2, 0), disabled(0, 0.5)});
  ASSERT_EQ(around.teammates.size(), 1U);
  EXPECT_DOUBLE_EQ(around.teammates[0].range_m, 1.0);
}

TEST(ForagePerception, DoesNotKnowTheBaseBeforeItWasSeen) {
  ForageEyes eyes;
  EXPECT_FALSE(eyes.look({mine(1, 1)}).nearest_of(Thing::Base).known());
}

TEST(ForagePerception, RemembersTheBaseThroughTheRobotsOwnMotion) {
  ForageEyes eyes;
  eyes.look({base(10, 0)});
  Percept moved = percept(0, {});
  moved.odometry = {{10.0, 5.0}, {0.0, 1.0}};  // Moved, and turned a quarter to the left.
  const Nearest& remembered = eyes.look(moved).nearest_of(Thing::Base);
  EXPECT_NEAR(remembered.offset_m.x(), -5.0, 1e-12);
  EXPECT_NEAR(remembered.offset_m.y(), 0.0, 1e-12);
  EXPECT_NEAR(remembered.squared_range_m2, 25.0, 1e-12);
}

TEST(ForagePerception, PassesOnHowTheRobotIs) {
  ForageEyes eyes;
  Percept now = percept(0, {});
  now.able = false;
  now.holding = true;
  now.deeds.stored = true;
  const Surroundings& around = eyes.look(now);
  EXPECT_FALSE(around.able);
  EXPECT_TRUE(around.holding);
  EXPECT_TRUE(around.deeds.stored);
}

TEST(ForagePerception, TracksTheNearestEnemy) {
  ForageEyes eyes;
  EXPECT_FALSE(eyes.look({enemy(5, 0)}).quarry.has_value());
  const auto motion = eyes.look({enemy(5, 0.25)}).quarry;
  ASSERT_TRUE(motion.has_value());
  EXPECT_EQ(motion->quarry_m_per_tick, OdometryVec(0, 0.25));
  EXPECT_FALSE(eyes.look(std::vector<Sighting>{}).quarry.has_value());
}

}  // namespace
}  // namespace tacit
