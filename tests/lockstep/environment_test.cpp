#include "deploy/lockstep/environment.h"

#include <gtest/gtest.h>

#include <set>
#include <string>

#include "deploy/lockstep/team.h"

namespace tacit {
namespace {

std::string printed(std::int64_t seed) {
  tacit::Setup setup = drawn_environment(seed);
  return to_toml(describing(setup));
}

TEST(DrawnEnvironment, IsTheSameForTheSameSeedAndOnlyThen) {
  EXPECT_EQ(printed(7), printed(7));
  EXPECT_NE(printed(7), printed(8));
}

TEST(DrawnEnvironment, CanBeBuiltWhateverTheSeed) {
  for (std::int64_t seed = 1; seed <= 60; ++seed) {
    tacit::Setup setup = drawn_environment(seed);
    setup.world.robots.count = 12;
    EXPECT_NO_THROW(Team(setup.world, setup.brain, 1)) << "seed " << seed;
  }
}

TEST(DrawnEnvironment, VariesNumberLayoutBaseAndObstacles) {
  std::set<std::int64_t> counts;
  std::set<std::string> layouts;
  std::set<double> bases;
  std::set<double> coverages;
  for (std::int64_t seed = 1; seed <= 40; ++seed) {
    const WorldConfig world = drawn_environment(seed).world;
    counts.insert(world.forage.mines.count);
    layouts.insert(world.forage.mines.layout);
    bases.insert(world.forage.base.x_m);
    coverages.insert(world.obstacles.coverage_percent);
  }
  EXPECT_GT(counts.size(), 10U);
  EXPECT_EQ(layouts.size(), 3U);
  EXPECT_GT(bases.size(), 10U);
  EXPECT_GT(coverages.size(), 10U);
}

TEST(DrawnEnvironment, ReadsBackFromItsOwnText) {
  ScenarioFile file = ScenarioFile::parse(printed(3), "drawn.toml");
  tacit::Setup again = read_setup(file);
  EXPECT_EQ(to_toml(describing(again)), printed(3));
}

}  // namespace
}  // namespace tacit
