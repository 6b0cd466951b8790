#include "robot_agent/brain/schemas/intercept_enemies.h"

#include <gtest/gtest.h>

#include "tests/brain/percepts.h"

namespace tacit {
namespace {

using testing::seen;

TEST(Lead, MeetsTheQuarry) {
  Stream chance(5, "lead");
  int met = 0;
  for (int trial = 0; trial < 1000; ++trial) {
    const BodyVec offset{chance.uniform(-50, 50), chance.uniform(-50, 50)};
    const BodyVec velocity{chance.uniform(-2, 2), chance.uniform(-2, 2)};
    const double speed = chance.uniform(0.1, 2.0);
    const auto heading = lead(unit(offset), velocity, speed);
    if (!heading) continue;
    ++met;
    EXPECT_NEAR(heading->norm(), 1.0, 1e-12);
    // Seen from the robot the quarry comes straight in, so nothing moves across the offset.
    const BodyVec relative = velocity - speed * *heading;
    EXPECT_NEAR(relative.cross(unit(offset)), 0.0, 1e-12);
    EXPECT_LT(relative.dot(offset), 0.0);
  }
  EXPECT_GT(met, 300);
}

TEST(Lead, AgreesWithTheLawOfSines) {
  // Quarry due ahead and going left at 3, robot at 5: asin(3/5) to the left.
  const auto heading = lead({1.0, 0.0}, {0.0, 3.0}, 5.0);
  ASSERT_TRUE(heading.has_value());
  EXPECT_NEAR(heading->x(), 0.8, 1e-12);
  EXPECT_NEAR(heading->y(), 0.6, 1e-12);
}

TEST(Lead, HasNoAnswerForAQuarryThatOutruns) {
  EXPECT_FALSE(lead({1.0, 0.0}, {2.0, 0.0}, 1.5).has_value());
  EXPECT_FALSE(lead({1.0, 0.0}, {0.0, 2.0}, 1.5).has_value());
  EXPECT_FALSE(lead({1.0, 0.0}, {0.0, 0.0}, 0.0).has_value());
}

Surroundings sees(Tick tick, const std::vector<Seen>& nearest_members) {
  Surroundings around;
  around.tick = tick;
  for (const Seen& member : nearest_members) around.groups.push_back({1, member.offset_m, member});
  return around;
}

TEST(InterceptEnemies, DoesNothingWithoutEnemies) {
  EXPECT_EQ(InterceptEnemies({}).push(sees(1, {})), BodyVec());
}

TEST(InterceptEnemies, GoesStraightAtAnEnemyJustSeen) {
  const BodyVec push = InterceptEnemies({}).push(sees(1, {seen(30, 40)}));
  EXPECT_NEAR(push.x(), 0.6, 1e-12);
  EXPECT_NEAR(push.y(), 0.8, 1e-12);
}

TEST(InterceptEnemies, TakesTheNearestGroupWhenAllAreOccluded) {
  const BodyVec push = InterceptEnemies({}).push(sees(1, {seen(0, 40), seen(30, 0)}));
  EXPECT_EQ(push, BodyVec(1, 0));
}

TEST(InterceptEnemies, TakesTheOpenGroupFirst) {
  Surroundings around = sees(1, {seen(0, 40), seen(30, 0)});
  around.open_group = &around.groups[0];
  EXPECT_EQ(InterceptEnemies({}).push(around), BodyVec(0, 1));
}

TEST(InterceptEnemies, LeadsAQuarryThatItHasTracked) {
  InterceptEnemies intercept({});
  BodyVec push;
  for (Tick tick = 0; tick < 8; ++tick) {
    const auto t = static_cast<double>(tick);
    // The robot goes ahead by 0.5 a tick, the quarry to the left by 0.3.
    Surroundings around = sees(tick, {seen(40.0 - 0.5 * t, 0.3 * t)});
    around.odometry.position_m = {0.5 * t, 0.0};
    push = intercept.push(around);
  }
  const BodyVec towards = unit(BodyVec{36.5, 2.1});
  const auto wanted = lead(towards, {0.0, 0.3}, 0.5);
  ASSERT_TRUE(wanted.has_value());
  EXPECT_NEAR(push.x(), wanted->x(), 1e-12);
  EXPECT_NEAR(push.y(), wanted->y(), 1e-12);
}

TEST(InterceptEnemies, GoesStraightAtAnotherQuarry) {
  InterceptEnemies intercept({});
  for (Tick tick = 0; tick < 8; ++tick) {
    Surroundings around = sees(tick, {seen(40.0, 0.3 * static_cast<double>(tick))});
    around.odometry.position_m = {0.5 * static_cast<double>(tick), 0.0};
    static_cast<void>(intercept.push(around));
  }
  EXPECT_EQ(intercept.push(sees(8, {seen(0, -20)})), BodyVec(0, -1));
}

}  // namespace
}  // namespace tacit
