#include <gtest/gtest.h>

#include "idl/types/config_error.h"
#include "idl/types/repulsion.h"
#include "robot_agent/brain/schemas/registry.h"
#include "tests/brain/percepts.h"

namespace tacit {
namespace {

using testing::seen;

void expect_near(const BodyVec& found, const BodyVec& wanted) {
  EXPECT_NEAR(found.x(), wanted.x(), 1e-12);
  EXPECT_NEAR(found.y(), wanted.y(), 1e-12);
}

TEST(Repulsion, IsNoneAtReachAndOneAtTheMargin) {
  EXPECT_EQ(repulsion(3.0, 3.0, 0.5), 0.0);
  EXPECT_EQ(repulsion(1.75, 3.0, 0.5), 0.5);
  EXPECT_NEAR(repulsion(0.5 + 1e-12, 3.0, 0.5), 1.0, 1e-11);
}

TEST(Repulsion, OutweighsAllElseInsideTheMargin) {
  EXPECT_EQ(repulsion(0.5, 3.0, 0.5), kInfiniteRepulsion);
  EXPECT_EQ(repulsion(-1.0, 3.0, 0.5), kInfiniteRepulsion);
}

BodyVec pull(double x, double y) {
  Surroundings around;
  around.target_m = BodyVec{x, y};
  return MoveToTarget({.unit_range_m = 25.0, .max_push = 4.0, .near_m = 1.0}).push(around);
}

TEST(MoveToTarget, PullsInProportionToRange) {
  expect_near(pull(25.0, 0.0), {1.0, 0.0});
  expect_near(pull(0.0, -50.0), {0.0, -2.0});
}

TEST(MoveToTarget, PullsAtMostFourfold) {
  expect_near(pull(100.0, 0.0), {4.0, 0.0});
  expect_near(pull(1000.0, 0.0), {4.0, 0.0});
}

TEST(MoveToTarget, PullsNothingNearIt) {
  expect_near(pull(0.999, 0.0), {0.0, 0.0});
  expect_near(pull(1.0, 0.0), {0.04, 0.0});
}

TEST(MoveToTarget, PullsNothingBeforeTheTargetWasSeen) {
  EXPECT_EQ(MoveToTarget({}).push(Surroundings{}), BodyVec());
}

BodyVec pushed_by(const std::vector<Seen>& mates) {
  Surroundings around;
  around.teammates = mates;
  return AvoidSoldiers({.reach_m = 75.0, .min_range_m = 2.0, .max_push = 1.0}).push(around);
}

TEST(AvoidSoldiers, PushesLinearlyFromReachToTheLeastRange) {
  expect_near(pushed_by({seen(75.0, 0.0)}), {0.0, 0.0});
  expect_near(pushed_by({seen(38.5, 0.0)}), {-0.5, 0.0});
  expect_near(pushed_by({seen(0.0, 2.0)}), {0.0, -1.0});
}

TEST(AvoidSoldiers, IsCapped) { expect_near(pushed_by({seen(0.1, 0.0)}), {-1.0, 0.0}); }

TEST(AvoidSoldiers, AddsTheCappedPushes) {
  expect_near(pushed_by({seen(1.0, 0.0), seen(2.0, 0.0), seen(0.0, -1.0)}), {-2.0, 1.0});
}

TEST(AvoidSoldiers, RefusesALeastRangeBeyondReach) {
  EXPECT_THROW(AvoidSoldiers({.reach_m = 2.0, .min_range_m = 2.0}), ConfigError);
}

BodyVec pushed_off(const std::vector<SeenObstacle>& obstacles) {
  Surroundings around;
  around.obstacles = obstacles;
  return AvoidObstacles({.reach_m = 3.0, .margin_m = 0.5}).push(around);
}

TEST(AvoidObstacles, MeasuresToTheSurface) {
  expect_near(pushed_off({{{5.0, 0.0}, 2.0}}), {0.0, 0.0});
  expect_near(pushed_off({{{3.75, 0.0}, 2.0}}), {-0.5, 0.0});
  expect_near(pushed_off({{{0.0, 1.75}, 0.0}}), {0.0, -0.5});
}

TEST(AvoidObstacles, OutweighsAllElseInsideTheMargin) {
  expect_near(pushed_off({{{2.5, 0.0}, 2.0}}), {-kInfiniteRepulsion, 0.0});
  expect_near(pushed_off({{{1.0, 0.0}, 2.0}}), {-kInfiniteRepulsion, 0.0});
}

TEST(AvoidObstacles, AddsThePushes) {
  expect_near(pushed_off({{{3.75, 0.0}, 2.0}, {{0.0, -1.75}, 0.0}}), {-0.5, 0.5});
}

TEST(AvoidObstacles, RefusesAMarginBeyondReach) {
  EXPECT_THROW(AvoidObstacles({.reach_m = 0.5, .margin_m = 0.5}), ConfigError);
}

Surroundings at(Tick tick, const Heading& heading) {
  Surroundings around;
  around.tick = tick;
  around.odometry.heading = heading;
  return around;
}

TEST(Noise, HasStrengthOne) {
  Noise noise({}, Self{RobotId{3}, 11});
  for (Tick tick = 0; tick < 100; ++tick) EXPECT_NEAR(noise.push(at(tick, {})).norm(), 1.0, 1e-12);
}

TEST(Noise, HoldsItsDirectionForThePersistence) {
  Noise noise({.persistence_ticks = 10}, Self{RobotId{3}, 11});
  const BodyVec first = noise.push(at(0, {}));
  EXPECT_EQ(noise.push(at(9, {})), first);
  EXPECT_FALSE(noise.push(at(10, {})) == first);
}

TEST(Noise, HoldsItsDirectionInTheOdometryFrame) {
  Noise noise({}, Self{RobotId{3}, 11});
  const BodyVec ahead = noise.push(at(0, {}));
  const BodyVec turned = noise.push(at(1, {0.0, 1.0}));
  expect_near(turned, {ahead.y(), -ahead.x()});
}

TEST(Noise, DiffersFromRobotToRobotAndSeedToSeed) {
  const BodyVec one = Noise({}, Self{RobotId{1}, 11}).push(at(0, {}));
  EXPECT_FALSE(Noise({}, Self{RobotId{2}, 11}).push(at(0, {})) == one);
  EXPECT_FALSE(Noise({}, Self{RobotId{1}, 12}).push(at(0, {})) == one);
}

TEST(Noise, GoesOnAfterARestartAsIfNothingHadHappened) {
  Noise lasting({}, Self{RobotId{3}, 11});
  for (Tick tick = 0; tick < 500; ++tick) static_cast<void>(lasting.push(at(tick, {})));
  EXPECT_EQ(Noise({}, Self{RobotId{3}, 11}).push(at(500, {})), lasting.push(at(500, {})));
}

TEST(Registry, NumbersTheSchemasInOrder) {
  EXPECT_EQ(kSchemaIndex<MoveToTarget>, 0U);
  EXPECT_EQ(kSchemaIndex<Noise>, SchemaTypes::kSize - 1);
}

}  // namespace
}  // namespace tacit
