#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "tests/world/lookout.h"

namespace tacit {
namespace {

struct Spread {
  double mean = 0.0;
  double deviation = 0.0;
};

Spread spread(const std::vector<double>& all) {
  Spread s;
  for (const double x : all) {
    s.mean += x / static_cast<double>(all.size());
  }
  for (const double x : all) {
    s.deviation += (x - s.mean) * (x - s.mean) / static_cast<double>(all.size());
  }
  s.deviation = std::sqrt(s.deviation);
  return s;
}

// A hundred enemies ten metres off, seen through noise for a few seeds.
std::vector<BodyVec> noisy_offsets(Lookout& lookout) {
  lookout.enemies.assign(100, {30.0, 20.0});
  std::vector<BodyVec> out;
  for (std::uint64_t seed = 1; seed <= 50; ++seed) {
    for (const Sighting& s : lookout.percept(seed).sightings) {
      out.push_back(s.offset_m);
    }
  }
  return out;
}

TEST(SightNoise, OfRangeHasItsDeviationAndLeavesBearingsAlone) {
  Lookout lookout;
  lookout.config.sight.range_noise_m = 0.5;
  std::vector<double> ranges;
  for (const BodyVec& offset : noisy_offsets(lookout)) {
    ranges.push_back(offset.norm());
    ASSERT_EQ(offset.y(), 0.0);
  }
  EXPECT_NEAR(spread(ranges).mean, 10.0, 0.04);
  EXPECT_NEAR(spread(ranges).deviation, 0.5, 0.03);
}

TEST(SightNoise, OfBearingHasItsDeviationAndLeavesRangesAlone) {
  Lookout lookout;
  lookout.config.sight.bearing_noise_deg = 3.0;
  std::vector<double> bearings;
  for (const BodyVec& offset : noisy_offsets(lookout)) {
    bearings.push_back(arc_tangent(offset.y(), offset.x()) * 180.0 / kPi);
    ASSERT_NEAR(offset.norm(), 10.0, 1e-12);
  }
  EXPECT_NEAR(spread(bearings).mean, 0.0, 0.22);
  EXPECT_NEAR(spread(bearings).deviation, 3.0, 0.15);
}

TEST(SightNoise, NeverTouchesTheRangeFinder) {
  Lookout lookout;
  lookout.terrain.obstacles = {{{24.0, 21.0}, 1.0}};
  const Percept exact = lookout.percept();
  lookout.config.sight.range_noise_m = 0.5;
  lookout.config.sight.bearing_noise_deg = 3.0;
  const Percept noisy = lookout.percept();
  ASSERT_EQ(noisy.obstacles.size(), 1u);
  EXPECT_EQ(noisy.obstacles[0].offset_m, exact.obstacles[0].offset_m);
  EXPECT_EQ(noisy.obstacles[0].radius_m, exact.obstacles[0].radius_m);
}

TEST(SightNoise, NeverTurnsThePictureInsideOut) {
  Lookout lookout;
  lookout.config.sight.range_noise_m = 100.0;
  for (const BodyVec& offset : noisy_offsets(lookout)) {
    ASSERT_GE(offset.x(), 0.0);
  }
}

TEST(SightNoise, IsDrawnAnewEveryTick) {
  Lookout lookout;
  lookout.enemies = {{30.0, 20.0}};
  lookout.config.sight.range_noise_m = 0.5;
  EXPECT_FALSE(lookout.percept(1, 1).sightings[0].offset_m ==
               lookout.percept(1, 2).sightings[0].offset_m);
}

TEST(SightNoise, OfOneRobotDoesNotDependOnTheOthers) {
  Lookout alone;
  alone.config.target = {30.0, 20.0, 1.0};
  alone.config.sight.range_noise_m = 0.5;
  Lookout together = alone;
  together.teammates.assign(5, {{60.0, 60.0}, {}});
  EXPECT_EQ(alone.percept().sightings[0].offset_m, together.percept().sightings[0].offset_m);
}

}  // namespace
}  // namespace tacit
