#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "tests/world/stage.h"

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
std::vector<BodyVec> noisy_offsets(Stage& stage) {
  stage.enemies.assign(100, {30.0, 20.0});
  std::vector<BodyVec> out;
  for (std::uint64_t seed = 1; seed <= 50; ++seed) {
    for (const Sighting& s : stage.percept(seed).sightings) {
      out.push_back(s.offset_m);
    }
  }
  return out;
}

TEST(SightNoise, OfRangeHasItsDeviationAndLeavesBearingsAlone) {
  Stage stage;
  stage.config.sight.range_noise_m = 0.5;
  std::vector<double> ranges;
  for (const BodyVec& offset : noisy_offsets(stage)) {
    ranges.push_back(offset.norm());
    ASSERT_EQ(offset.y(), 0.0);
  }
  EXPECT_NEAR(spread(ranges).mean, 10.0, 0.04);
  EXPECT_NEAR(spread(ranges).deviation, 0.5, 0.03);
}

TEST(SightNoise, OfBearingHasItsDeviationAndLeavesRangesAlone) {
  Stage stage;
  stage.config.sight.bearing_noise_deg = 3.0;
  std::vector<double> bearings;
  for (const BodyVec& offset : noisy_offsets(stage)) {
    bearings.push_back(arc_tangent(offset.y(), offset.x()) * 180.0 / kPi);
    ASSERT_NEAR(offset.norm(), 10.0, 1e-12);
  }
  EXPECT_NEAR(spread(bearings).mean, 0.0, 0.22);
  EXPECT_NEAR(spread(bearings).deviation, 3.0, 0.15);
}

TEST(SightNoise, NeverTouchesTheRangeFinder) {
  Stage stage;
  stage.terrain.obstacles = {{{24.0, 21.0}, 1.0}};
  const Percept exact = stage.percept();
  stage.config.sight.range_noise_m = 0.5;
  stage.config.sight.bearing_noise_deg = 3.0;
  const Percept noisy = stage.percept();
  ASSERT_EQ(noisy.obstacles.size(), 1u);
  EXPECT_EQ(noisy.obstacles[0].offset_m, exact.obstacles[0].offset_m);
  EXPECT_EQ(noisy.obstacles[0].radius_m, exact.obstacles[0].radius_m);
}

TEST(SightNoise, NeverTurnsThePictureInsideOut) {
  Stage stage;
  stage.config.sight.range_noise_m = 100.0;
  for (const BodyVec& offset : noisy_offsets(stage)) {
    ASSERT_GE(offset.x(), 0.0);
  }
}

TEST(SightNoise, IsDrawnAnewEveryTick) {
  Stage stage;
  stage.enemies = {{30.0, 20.0}};
  stage.config.sight.range_noise_m = 0.5;
  EXPECT_FALSE(stage.percept(1, 1).sightings[0].offset_m ==
               stage.percept(1, 2).sightings[0].offset_m);
}

TEST(SightNoise, OfOneRobotDoesNotDependOnTheOthers) {
  Stage alone;
  alone.config.target = {30.0, 20.0, 1.0};
  alone.config.sight.range_noise_m = 0.5;
  Stage together = alone;
  together.teammates.assign(5, {{60.0, 60.0}, {}});
  EXPECT_EQ(alone.percept().sightings[0].offset_m, together.percept().sightings[0].offset_m);
}

}  // namespace
}  // namespace tacit
