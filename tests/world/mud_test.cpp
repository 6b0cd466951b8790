#include "world_server/world/missions/mud.h"

#include <gtest/gtest.h>

#include <cmath>

namespace tacit {
namespace {

TEST(Mud, SticksAtTheRateAsked) {
  constexpr double kRate = 0.01;
  constexpr int kRobots = 1000;
  constexpr int kTicks = 1000;
  Mud mud(kRate, 7, kRobots);
  int stuck = 0;
  for (int tick = 0; tick < kTicks; ++tick) {
    for (std::size_t robot = 0; robot < kRobots; ++robot) {
      stuck += static_cast<int>(mud.sticks(robot));
    }
  }
  // Five standard deviations of a binomial count.
  const double expected = kRate * kRobots * kTicks;
  EXPECT_NEAR(stuck, expected, 5.0 * std::sqrt(expected * (1.0 - kRate)));
}

TEST(Mud, SticksAsOftenRightAfterAMishapAsEver) {
  constexpr double kRate = 0.2;
  Mud mud(kRate, 7, 1);
  int mishaps = 0;
  int at_once = 0;
  bool before = false;
  for (int tick = 0; tick < 200000; ++tick) {
    const bool now = mud.sticks(0);
    mishaps += static_cast<int>(before);
    at_once += static_cast<int>(before && now);
    before = now;
  }
  EXPECT_NEAR(at_once, kRate * mishaps, 5.0 * std::sqrt(kRate * (1.0 - kRate) * mishaps));
}

TEST(Mud, IsAbsentAtRateZeroAndEverywhereAtRateOne) {
  Mud none(0.0, 7, 3);
  Mud all(1.0, 7, 3);
  for (int tick = 0; tick < 1000; ++tick) {
    for (std::size_t robot = 0; robot < 3; ++robot) {
      ASSERT_FALSE(none.sticks(robot));
      ASSERT_TRUE(all.sticks(robot));
    }
  }
}

TEST(Mud, IsEveryRobotsOwn) {
  Mud alone(0.1, 7, 1);
  Mud among_others(0.1, 7, 2);
  int different = 0;
  for (int tick = 0; tick < 1000; ++tick) {
    const bool first = among_others.sticks(0);
    different += static_cast<int>(among_others.sticks(1) != first);
    ASSERT_EQ(alone.sticks(0), first);
  }
  EXPECT_GT(different, 50);
}

}  // namespace
}  // namespace tacit
