#include "console/metrics/idle_spread.h"

#include <gtest/gtest.h>

namespace tacit {
namespace {

Event checkpoint(std::uint32_t enemies, double distance_m, double speed_mps) {
  return {1, Checkpoint{0, enemies, distance_m, speed_mps}};
}

TEST(IdleSpread, LooksAtTheLaterHalfOnly) {
  IdleSpread spread;
  spread.add(checkpoint(0, 1000.0, 50.0));
  spread.add(checkpoint(0, 1000.0, 50.0));
  spread.add(checkpoint(0, 10.0, 1.0));
  spread.add(checkpoint(0, 14.0, 3.0));

  EXPECT_EQ(spread.mean_distance_m(), 12.0);
  EXPECT_EQ(spread.mean_speed_mps(), 2.0);
  EXPECT_DOUBLE_EQ(spread.sd_distance_m().value(), 2.8284271247461903);
}

TEST(IdleSpread, CountsTheMiddleCheckpointToTheLaterHalf) {
  IdleSpread spread;
  spread.add(checkpoint(0, 1000.0, 0.0));
  spread.add(checkpoint(0, 10.0, 0.0));
  spread.add(checkpoint(0, 20.0, 0.0));

  EXPECT_EQ(spread.mean_distance_m(), 15.0);
}

TEST(IdleSpread, LeavesOutCheckpointsWithEnemies) {
  IdleSpread spread;
  spread.add(checkpoint(0, 10.0, 1.0));
  spread.add(checkpoint(3, 1000.0, 50.0));

  EXPECT_EQ(spread.mean_distance_m(), 10.0);
  EXPECT_EQ(spread.mean_speed_mps(), 1.0);
}

TEST(IdleSpread, IsAbsentForATeamThatWasNeverIdle) {
  IdleSpread spread;
  spread.add(checkpoint(1, 10.0, 1.0));

  EXPECT_EQ(spread.mean_distance_m(), std::nullopt);
  EXPECT_EQ(spread.sd_distance_m(), std::nullopt);
  EXPECT_EQ(spread.mean_speed_mps(), std::nullopt);
}

TEST(IdleSpread, OneCheckpointHasNoDeviation) {
  IdleSpread spread;
  spread.add(checkpoint(0, 10.0, 1.0));

  EXPECT_EQ(spread.sd_distance_m(), std::nullopt);
}

}  // namespace
}  // namespace tacit
