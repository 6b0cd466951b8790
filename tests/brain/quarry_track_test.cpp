#include "robot_agent/brain/perception/quarry_track.h"

#include <gtest/gtest.h>

namespace tacit {
namespace {

QuarryTrack track() { return QuarryTrack({.average_ticks = 5, .gate_m = 0.5}); }

TEST(QuarryTrack, KnowsNoMotionFromOneSighting) {
  QuarryTrack quarry = track();
  quarry.note(1, {5.0, 0.0}, {});
  EXPECT_FALSE(quarry.motion().has_value());
}

TEST(QuarryTrack, MeasuresBothMotionsPerTick) {
  QuarryTrack quarry = track();
  for (Tick tick = 0; tick < 20; ++tick) {
    const auto t = static_cast<double>(tick);
    quarry.note(tick, {5.0 + 0.25 * t, -0.125 * t}, {0.0, 0.5 * t});
  }
  ASSERT_TRUE(quarry.motion().has_value());
  EXPECT_EQ(quarry.motion()->quarry_m_per_tick, OdometryVec(0.25, -0.125));
  EXPECT_EQ(quarry.motion()->self_m_per_tick, OdometryVec(0.0, 0.5));
}

TEST(QuarryTrack, AveragesOverTheLastFiveTicks) {
  QuarryTrack quarry = track();
  double x = 0.0;
  for (Tick tick = 0; tick <= 10; ++tick) {
    quarry.note(tick, {x, 0.0}, {});
    x += tick < 5 ? 0.125 : 0.25;
  }
  EXPECT_EQ(quarry.motion()->quarry_m_per_tick, OdometryVec(0.25, 0.0));
}

TEST(QuarryTrack, BeginsAnewBeyondTheGate) {
  QuarryTrack quarry = track();
  quarry.note(1, {5.0, 0.0}, {});
  quarry.note(2, {5.501, 0.0}, {});
  EXPECT_FALSE(quarry.motion().has_value());
}

TEST(QuarryTrack, ContinuesUpToTheGate) {
  QuarryTrack quarry = track();
  quarry.note(1, {5.0, 0.0}, {});
  quarry.note(2, {5.5, 0.0}, {});
  EXPECT_TRUE(quarry.motion().has_value());
}

TEST(QuarryTrack, ExpectsTheQuarryToKeepItsSpeed) {
  QuarryTrack quarry = track();
  quarry.note(1, {5.0, 0.0}, {});
  quarry.note(2, {5.4, 0.0}, {});
  quarry.note(3, {6.2, 0.0}, {});  // 0.8 from where it was, 0.4 from where it was expected.
  ASSERT_TRUE(quarry.motion().has_value());
  EXPECT_NEAR(quarry.motion()->quarry_m_per_tick.x(), 0.6, 1e-12);
}

TEST(QuarryTrack, BeginsAnewAfterAMissedTick) {
  QuarryTrack quarry = track();
  quarry.note(1, {5.0, 0.0}, {});
  quarry.note(3, {5.1, 0.0}, {});
  EXPECT_FALSE(quarry.motion().has_value());
}

}  // namespace
}  // namespace tacit
