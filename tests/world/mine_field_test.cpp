#include "world_server/world/missions/mine_field.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/world/forage_field.h"

namespace tacit {
namespace {

constexpr std::uint64_t kSeeds = 20;

WorldConfig laid(const std::string& layout, std::int64_t count = 20) {
  WorldConfig config = world_defaults(MissionKind::Forage);
  config.forage.mines.layout = layout;
  config.forage.mines.count = count;
  return config;
}

std::vector<WorldVec> mines(const WorldConfig& config, std::uint64_t seed = 1) {
  return lay_mines(config, make_terrain(config, seed), seed);
}

double from_border_m(const WorldConfig& config, const WorldVec& p) {
  return std::min({p.x(), p.y(), config.area.width_m - p.x(), config.area.height_m - p.y()});
}

class Layout : public testing::TestWithParam<const char*> {};

TEST_P(Layout, LaysAsManyAsAskedForAwayFromBaseObstaclesWallsAndOneAnother) {
  WorldConfig config = laid(GetParam(), 40);
  config.obstacles.coverage_percent = 5.0;
  config.area.walls = {{40.0, 2.0, 40.0, 58.0}};
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
    const Terrain terrain = make_terrain(config, seed);
    const std::vector<WorldVec> places = lay_mines(config, terrain, seed);
    ASSERT_EQ(places.size(), 40u);
    for (std::size_t i = 0; i < places.size(); ++i) {
      ASSERT_GE((places[i] - WorldVec{30.0, 30.0}).norm(), config.forage.mines.keep_from_base_m);
      ASSERT_GE(from_border_m(config, places[i]), 1.0);
      ASSERT_GE(clearance_m(terrain, places[i]), 3.0 * config.robots.radius_m);
      for (std::size_t j = 0; j < i; ++j) {
        ASSERT_GE((places[i] - places[j]).norm(), 0.5);
      }
    }
  }
}

TEST_P(Layout, FollowsTheRunsSeedUnlessItHasItsOwn) {
  WorldConfig config = laid(GetParam());
  EXPECT_EQ(mines(config, 1), mines(config, 1));
  EXPECT_NE(mines(config, 1), mines(config, 2));
  config.forage.mines.seed = 5;
  EXPECT_EQ(mines(config, 1), mines(config, 2));
}

TEST_P(Layout, NamesWhatHasNoRoom) {
  WorldConfig config = laid(GetParam(), 1000);
  config.area.width_m = 20.0;
  config.area.height_m = 20.0;
  config.forage.base = {10.0, 10.0, 0.5};
  config.forage.mines.keep_from_base_m = 4.0;
  const std::string text = refusal(config);
  EXPECT_EQ(text.find("[mines] count = 1000: no room for mine "), 0u) << text;
  EXPECT_NE(text.find("in the layout \"" + std::string(GetParam()) + "\""), std::string::npos);
}

INSTANTIATE_TEST_SUITE_P(Mines, Layout, testing::Values("scattered", "clusters", "ring"));

TEST(ScatteredMines, LieInEveryQuarterOfTheArea) {
  int quarters[2][2] = {};
  for (const WorldVec& p : mines(laid("scattered", 200))) {
    ++quarters[p.x() > 30.0][p.y() > 30.0];
  }
  for (const auto& row : quarters) {
    for (const int count : row) {
      EXPECT_NEAR(count, 50, 5 * std::sqrt(200.0 * 0.25 * 0.75));
    }
  }
}

TEST(ClusteredMines, LieInAsManyDiscsAsAskedForAndAreDealtInTurn) {
  const WorldConfig config = laid("clusters", 22);
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
    const std::vector<WorldVec> places = mines(config, seed);
    for (std::size_t i = 4; i < places.size(); ++i) {
      ASSERT_LE((places[i] - places[i % 4]).norm(), 2.0 * config.forage.mines.cluster_radius_m);
    }
  }
}

TEST(RingedMines, LieAtTheInsetFromTheBorder) {
  WorldConfig config = laid("ring");
  config.forage.mines.ring_inset_m = 2.5;
  for (const WorldVec& p : mines(config)) {
    EXPECT_NEAR(from_border_m(config, p), 2.5, 1e-12);
  }
}

TEST(GivenMines, ComeFirstAndWhereTheyAreTold) {
  WorldConfig config = laid("scattered", 3);
  config.forage.mines.places = {{31.0, 30.0}, {0.5, 0.5}};
  const std::vector<WorldVec> places = mines(config);
  ASSERT_EQ(places.size(), 5u);
  EXPECT_EQ(places[0], (WorldVec{31.0, 30.0}));
  EXPECT_EQ(places[1], (WorldVec{0.5, 0.5}));
}

TEST(GivenMines, InAGivenObstacleAreRefused) {
  WorldConfig config = laid("scattered");
  config.forage.mines.places = {{10.0, 10.0}};
  config.obstacles.discs = {{10.5, 10.0, 1.0}};
  EXPECT_EQ(refusal(config), "[mines] places holds a point in an obstacle; wanted all in the open");
}

TEST(GivenMines, KeepObstaclesLaidByChanceAway) {
  WorldConfig config = laid("scattered");
  config.obstacles.coverage_percent = 20.0;
  config.forage.mines.places = {{10.0, 10.0}, {50.0, 12.0}};
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
    const Terrain terrain = make_terrain(config, seed);
    ASSERT_GE(clearance_m(terrain, {10.0, 10.0}), 3.0 * config.robots.radius_m);
    ASSERT_GE(clearance_m(terrain, {50.0, 12.0}), 3.0 * config.robots.radius_m);
  }
}

TEST(ForageTerrain, KeepsTheSurroundingsOfTheBaseFree) {
  WorldConfig config = laid("scattered");
  config.obstacles.coverage_percent = 20.0;
  config.forage.base = {12.0, 48.0, 0.5};
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
    ASSERT_GE(clearance_m(make_terrain(config, seed), {12.0, 48.0}),
              config.obstacles.keep_free_m - 1e-12);
  }
}

TEST(ForageStart, IsARingRoundTheBase) {
  const Field field(bare_field(4));
  for (std::size_t i = 1; i <= 4; ++i) {
    EXPECT_NEAR((field.place(i) - WorldVec{20.0, 20.0}).norm(), 2.0, 1e-12);
  }
}

TEST(Rim, GoesRoundTheInsetRectangleOnce) {
  const Terrain terrain{40.0, 20.0, true, {}, {}};
  EXPECT_EQ(rim_place(terrain, 1.0, 0.0), (WorldVec{1.0, 1.0}));
  EXPECT_EQ(rim_place(terrain, 1.0, 0.5), (WorldVec{39.0, 19.0}));
  int sides[4] = {};
  for (int i = 0; i < 1120; ++i) {
    const WorldVec p = rim_place(terrain, 1.0, i / 1120.0);
    const double off[4] = {p.y() - 1.0, 39.0 - p.x(), 19.0 - p.y(), p.x() - 1.0};
    const auto* least = std::min_element(off, off + 4);
    ASSERT_NEAR(*least, 0.0, 1e-9);
    ++sides[least - off];
  }
  // As long as the sides are, give or take a corner.
  EXPECT_NEAR(sides[0], 380, 1);
  EXPECT_NEAR(sides[1], 180, 1);
  EXPECT_NEAR(sides[2], 380, 1);
  EXPECT_NEAR(sides[3], 180, 1);
}

}  // namespace
}  // namespace tacit
