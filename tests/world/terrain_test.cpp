#include "world_server/world/terrain.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "tests/world/sample_worlds.h"

namespace tacit {
namespace {

constexpr std::uint64_t kSeeds = 30;

double area_m2(const Disc& disc) { return kPi * disc.radius_m * disc.radius_m; }

double covered_m2(const Terrain& terrain) {
  double sum = 0.0;
  for (const Disc& disc : terrain.obstacles) {
    sum += area_m2(disc);
  }
  return sum;
}

bool same(const Terrain& a, const Terrain& b) {
  return std::equal(a.obstacles.begin(), a.obstacles.end(), b.obstacles.begin(), b.obstacles.end(),
                    [](const Disc& x, const Disc& y) {
                      return x.centre_m == y.centre_m && x.radius_m == y.radius_m;
                    });
}

WorldConfig field(double coverage_percent) {
  WorldConfig config;
  config.obstacles.coverage_percent = coverage_percent;
  return config;
}

TEST(Terrain, CoversWhatWasAskedForAndNoMoreThanTheLastObstacleBeyond) {
  const WorldConfig config = field(10.0);
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
    const Terrain terrain = make_terrain(config, seed);
    const double wanted = 0.10 * config.area.width_m * config.area.height_m;
    ASSERT_GE(covered_m2(terrain), wanted);
    ASSERT_LT(covered_m2(terrain) - area_m2(terrain.obstacles.back()), wanted);
  }
}

TEST(Terrain, IsBareWhenNoCoverageIsWanted) {
  EXPECT_TRUE(make_terrain(field(0.0), 1).obstacles.empty());
}

TEST(Terrain, HasNoOverlappingObstacles) {
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
    const Terrain terrain = make_terrain(field(20.0), seed);
    for (std::size_t i = 0; i < terrain.obstacles.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        const Disc& a = terrain.obstacles[i];
        const Disc& b = terrain.obstacles[j];
        ASSERT_GE((a.centre_m - b.centre_m).norm(), (a.radius_m + b.radius_m) * (1.0 - 1e-12));
      }
    }
  }
}

TEST(Terrain, LeavesTheTargetsSurroundingsFree) {
  WorldConfig config = field(20.0);
  config.target.x_m = 60.0;
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
    for (const Disc& disc : make_terrain(config, seed).obstacles) {
      const WorldVec target{config.target.x_m, config.target.y_m};
      ASSERT_GE((disc.centre_m - target).norm() - disc.radius_m, config.obstacles.keep_free_m);
    }
  }
}

TEST(Terrain, HasItsObstaclesWholeInsideTheArea) {
  WorldConfig config = field(20.0);
  config.area.height_m = 120.0;
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
    for (const Disc& disc : make_terrain(config, seed).obstacles) {
      ASSERT_GE(disc.centre_m.x() - disc.radius_m, -1e-9);
      ASSERT_GE(disc.centre_m.y() - disc.radius_m, -1e-9);
      ASSERT_LE(disc.centre_m.x() + disc.radius_m, 200.0 + 1e-9);
      ASSERT_LE(disc.centre_m.y() + disc.radius_m, 120.0 + 1e-9);
    }
  }
}

TEST(Terrain, UsesTheWholeRangeOfRadii) {
  const WorldConfig config = field(20.0);
  double least = 1e9;
  double most = 0.0;
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
    for (const Disc& disc : make_terrain(config, seed).obstacles) {
      least = std::min(least, disc.radius_m);
      most = std::max(most, disc.radius_m);
    }
  }
  EXPECT_GE(least, config.obstacles.min_radius_m);
  EXPECT_LT(least, config.obstacles.min_radius_m + 0.1);
  EXPECT_LE(most, config.obstacles.max_radius_m);
  EXPECT_GT(most, config.obstacles.max_radius_m - 0.1);
}

TEST(Terrain, IsTheSameForTheSameSeed) {
  EXPECT_TRUE(same(make_terrain(field(5.0), 7), make_terrain(field(5.0), 7)));
}

TEST(Terrain, IsAnotherForAnotherSeed) {
  EXPECT_FALSE(same(make_terrain(field(5.0), 7), make_terrain(field(5.0), 8)));
}

TEST(Terrain, WithItsOwnSeedDoesNotFollowTheRuns) {
  WorldConfig config = field(5.0);
  config.obstacles.seed = 99;
  EXPECT_TRUE(same(make_terrain(config, 7), make_terrain(config, 8)));
}

TEST(Terrain, WithAnotherSeedOfItsOwnIsAnother) {
  WorldConfig config = field(5.0);
  config.obstacles.seed = 99;
  WorldConfig other = config;
  other.obstacles.seed = 100;
  EXPECT_FALSE(same(make_terrain(config, 7), make_terrain(other, 7)));
}

TEST(Terrain, HoldsGivenObstaclesWhereTheyWerePutAndKeepsOthersOff) {
  WorldConfig config = field(10.0);
  config.obstacles.discs = {{20.0, 30.0, 15.0}};
  const Terrain terrain = make_terrain(config, 3);
  EXPECT_EQ(terrain.obstacles.front().centre_m, (WorldVec{20.0, 30.0}));
  EXPECT_EQ(terrain.obstacles.front().radius_m, 15.0);
  for (std::size_t i = 1; i < terrain.obstacles.size(); ++i) {
    const Disc& disc = terrain.obstacles[i];
    ASSERT_GE((disc.centre_m - WorldVec{20.0, 30.0}).norm(), disc.radius_m + 15.0 - 1e-9);
  }
}

TEST(Terrain, KeepsObstaclesOffTheWalls) {
  WorldConfig config = field(20.0);
  config.area.walls = {{0.0, 50.0, 200.0, 50.0}};
  for (const Disc& disc : make_terrain(config, 3).obstacles) {
    ASSERT_GE(std::abs(disc.centre_m.y() - 50.0), disc.radius_m);
  }
}

TEST(Terrain, ThatCannotHoldTheCoverageSaysHowMuchFits) {
  WorldConfig config = field(60.0);
  config.obstacles.min_radius_m = 9.0;
  config.obstacles.max_radius_m = 10.0;
  const std::string text = refusal(config);
  EXPECT_NE(text.find("[obstacles] coverage_percent = 60 cannot be placed"), std::string::npos);
  const std::size_t only = text.find("only ");
  ASSERT_NE(only, std::string::npos) << text;
  const double fits = std::stod(text.substr(only + 5));
  EXPECT_GT(fits, 20.0);
  EXPECT_LT(fits, 60.0);
}

TEST(Terrain, RefusesObstaclesLargerThanTheArea) {
  WorldConfig config = field(1.0);
  config.obstacles.min_radius_m = 150.0;
  config.obstacles.max_radius_m = 160.0;
  EXPECT_NE(refusal(config).find("only 0.0 % of the area is free enough"), std::string::npos);
}

TEST(NearestPointOfAWall, IsTheFootOfThePerpendicularOrTheNearerEnd) {
  const Wall wall{{0.0, 0.0}, {10.0, 0.0}};
  EXPECT_EQ(nearest_point(wall, {4.0, 3.0}), (WorldVec{4.0, 0.0}));
  EXPECT_EQ(nearest_point(wall, {-4.0, 3.0}), (WorldVec{0.0, 0.0}));
  EXPECT_EQ(nearest_point(wall, {14.0, -3.0}), (WorldVec{10.0, 0.0}));
}

TEST(NearestPointOfAWall, IsItsPlaceWhenItHasNoLength) {
  EXPECT_EQ(nearest_point({{2.0, 3.0}, {2.0, 3.0}}, {5.0, 5.0}), (WorldVec{2.0, 3.0}));
}

}  // namespace
}  // namespace tacit
