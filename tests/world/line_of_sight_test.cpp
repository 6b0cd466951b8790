#include "world_server/world/sensing/line_of_sight.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "idl/types/random.h"

namespace tacit {
namespace {

constexpr double kSide_m = 60.0;
constexpr LineOfSight::Blockers kBoth{true, true};

WorldVec somewhere(Stream& chance) {
  return {chance.uniform(0.0, kSide_m), chance.uniform(0.0, kSide_m)};
}

Terrain random_terrain(Stream& chance) {
  Terrain terrain{kSide_m, kSide_m, true, {}, {}};
  for (int i = 0; i < 8; ++i) {
    terrain.obstacles.push_back({somewhere(chance), chance.uniform(0.5, 4.0)});
    const WorldVec from = somewhere(chance);
    const WorldVec along{chance.uniform(-8.0, 8.0), chance.uniform(-8.0, 8.0)};
    terrain.walls.push_back({from, from + along});
  }
  return terrain;
}

WorldVec outside_discs(const Terrain& terrain, Stream& chance) {
  for (;;) {
    const WorldVec p = somewhere(chance);
    if (std::none_of(terrain.obstacles.begin(), terrain.obstacles.end(), [&p](const Disc& disc) {
          return (disc.centre_m - p).norm() <= disc.radius_m;
        })) {
      return p;
    }
  }
}

bool clear(const Terrain& terrain, const WorldVec& a, const WorldVec& b,
           LineOfSight::Blockers blockers = kBoth) {
  LineOfSight sight(terrain, 2.0 * kSide_m, blockers);
  sight.look_from(a);
  return sight.clear(b - a);
}

// How deep the sampled line goes into a disc, negative when it stays outside all.
double depth_in_discs(const Terrain& terrain, const WorldVec& a, const WorldVec& b) {
  double deepest = -1e9;
  for (int i = 0; i <= 2000; ++i) {
    const WorldVec p = a + (i / 2000.0) * (b - a);
    for (const Disc& disc : terrain.obstacles) {
      deepest = std::max(deepest, disc.radius_m - (disc.centre_m - p).norm());
    }
  }
  return deepest;
}

TEST(LineOfSight, AgreesWithAFinelySampledLineAboutObstacles) {
  Stream chance(1, "sight");
  int hidden = 0;
  for (int round = 0; round < 400; ++round) {
    Terrain terrain = random_terrain(chance);
    terrain.walls.clear();
    const WorldVec a = outside_discs(terrain, chance);
    const WorldVec b = outside_discs(terrain, chance);
    const double depth = depth_in_discs(terrain, a, b);
    // Samples 4 cm apart see a grazing line only this well.
    if (std::abs(depth) < 0.01) {
      continue;
    }
    ASSERT_EQ(clear(terrain, a, b), depth < 0.0);
    hidden += static_cast<int>(depth > 0.0);
  }
  EXPECT_GT(hidden, 50);
  EXPECT_LT(hidden, 350);
}

// Where two lines through a-b and the wall meet, as a share of each, by Cramer's rule.
bool crosses(const Wall& wall, const WorldVec& a, const WorldVec& b) {
  const WorldVec r = b - a;
  const WorldVec s = wall.to_m - wall.from_m;
  const double t = (wall.from_m - a).cross(s) / r.cross(s);
  const double u = (wall.from_m - a).cross(r) / r.cross(s);
  return t > 0.0 && t < 1.0 && u > 0.0 && u < 1.0;
}

TEST(LineOfSight, AgreesWithTheCrossingOfLinesAboutWalls) {
  Stream chance(2, "sight");
  int hidden = 0;
  for (int round = 0; round < 1000; ++round) {
    Terrain terrain = random_terrain(chance);
    terrain.obstacles.clear();
    const WorldVec a = somewhere(chance);
    const WorldVec b = somewhere(chance);
    const bool expected = std::any_of(terrain.walls.begin(), terrain.walls.end(),
                                      [&](const Wall& wall) { return crosses(wall, a, b); });
    ASSERT_EQ(clear(terrain, a, b), !expected);
    hidden += static_cast<int>(expected);
  }
  EXPECT_GT(hidden, 100);
  EXPECT_LT(hidden, 900);
}

TEST(LineOfSight, IsTheSameFromBothEnds) {
  Stream chance(3, "sight");
  for (int round = 0; round < 2000; ++round) {
    const Terrain terrain = random_terrain(chance);
    const WorldVec a = outside_discs(terrain, chance);
    const WorldVec b = outside_discs(terrain, chance);
    ASSERT_EQ(clear(terrain, a, b), clear(terrain, b, a));
  }
}

TEST(LineOfSight, DoesNotDependOnWhereItLookedFromBefore) {
  Stream chance(4, "sight");
  const Terrain terrain = random_terrain(chance);
  LineOfSight sight(terrain, 2.0 * kSide_m, kBoth);
  for (int round = 0; round < 200; ++round) {
    const WorldVec a = outside_discs(terrain, chance);
    const WorldVec b = outside_discs(terrain, chance);
    sight.look_from(a);
    ASSERT_EQ(sight.clear(b - a), clear(terrain, a, b));
  }
}

TEST(LineOfSight, IsHiddenByAnObstacleBetweenAndNotByOneBehind) {
  const Terrain terrain{kSide_m, kSide_m, true, {{{30.0, 30.0}, 2.0}}, {}};
  EXPECT_FALSE(clear(terrain, {20.0, 31.0}, {40.0, 31.0}));
  EXPECT_TRUE(clear(terrain, {20.0, 30.0}, {27.0, 30.0}));
  EXPECT_TRUE(clear(terrain, {33.0, 30.0}, {40.0, 30.0}));
}

TEST(LineOfSight, PassesAnObstacleItOnlyTouches) {
  const Terrain terrain{kSide_m, kSide_m, true, {{{30.0, 30.0}, 2.0}}, {}};
  EXPECT_TRUE(clear(terrain, {20.0, 32.0}, {40.0, 32.0}));
  EXPECT_FALSE(clear(terrain, {20.0, 31.999}, {40.0, 31.999}));
}

TEST(LineOfSight, SeesThroughObstaclesWhenTheyDoNotBlock) {
  const Terrain terrain{
      kSide_m, kSide_m, true, {{{30.0, 30.0}, 2.0}}, {{{35.0, 20.0}, {35.0, 40.0}}}};
  EXPECT_FALSE(clear(terrain, {20.0, 30.0}, {40.0, 30.0}, {false, true}));
  EXPECT_TRUE(clear(terrain, {20.0, 30.0}, {34.0, 30.0}, {false, true}));
}

TEST(LineOfSight, SeesThroughWallsWhenTheyDoNotBlock) {
  const Terrain terrain{
      kSide_m, kSide_m, true, {{{30.0, 30.0}, 2.0}}, {{{35.0, 20.0}, {35.0, 40.0}}}};
  EXPECT_FALSE(clear(terrain, {20.0, 30.0}, {40.0, 30.0}, {true, false}));
  EXPECT_TRUE(clear(terrain, {33.0, 30.0}, {40.0, 30.0}, {true, false}));
}

}  // namespace
}  // namespace tacit
