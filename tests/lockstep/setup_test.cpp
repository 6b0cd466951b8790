#include "deploy/lockstep/setup.h"

#include <gtest/gtest.h>

#include <string>

#include "idl/types/config_error.h"

namespace tacit {
namespace {

Setup setup_of(const std::string& text) {
  ScenarioFile file = ScenarioFile::parse(text, "test.toml");
  return read_setup(file);
}

std::string refusal(const std::string& text) {
  try {
    static_cast<void>(setup_of(text));
  } catch (const ConfigError& error) {
    return error.what();
  }
  return {};
}

std::string printed(Setup setup) { return to_toml(describing(setup)); }

// GoogleTest has a member of that name, so tests write tacit::Setup.
TEST(Setup, OfAnEmptyFileHasTheDefaults) {
  EXPECT_EQ(printed(setup_of("")), printed(tacit::Setup{}));
}

TEST(Setup, ForAMissionIsThatOfAFileThatNamesNothingElse) {
  EXPECT_EQ(printed(setup_for(MissionKind::Guard)), printed(setup_of("")));
  EXPECT_EQ(printed(setup_for(MissionKind::Forage)),
            printed(setup_of("[scenario]\nmission = \"forage\"\n")));
}

TEST(Setup, ReachesRunWorldAndBrain) {
  const tacit::Setup setup =
      setup_of("[run]\nseed = 5\n[robots]\ncount = 3\n[brain]\nlearner = \"static2\"\n");
  EXPECT_EQ(seed(setup), 5u);
  EXPECT_EQ(setup.world.robots.count, 3);
  EXPECT_EQ(setup.brain.learner, "static2");
}

TEST(Setup, EndsAfterItsDurationInTicks) {
  EXPECT_EQ(last_tick(setup_of("[run]\nduration_s = 12.0\n[physics]\ntick_s = 0.05\n")), 240u);
}

TEST(Setup, RefusesASectionThatNobodyKnows) {
  EXPECT_NE(refusal("[robot]\ncount = 3\n").find("robot"), std::string::npos);
}

TEST(Setup, RefusesZeroRobots) {
  EXPECT_NE(refusal("[robots]\ncount = 0\n").find("test.toml:2"), std::string::npos);
}

TEST(Setup, RefusesANegativeRadius) {
  EXPECT_NE(refusal("[robots]\nradius_m = -0.2\n").find("radius_m = -0.2"), std::string::npos);
}

TEST(Setup, RefusesALearnerThatDoesNotExist) {
  EXPECT_NE(refusal("[brain]\nlearner = \"genius\"\n").find("genius"), std::string::npos);
}

TEST(Setup, RefusesContradictionsInTheWorld) {
  EXPECT_NE(refusal("[target]\nx_m = 500.0\n").find("[target]"), std::string::npos);
}

TEST(Setup, IsTheSameAfterPrintingAndReading) {
  tacit::Setup odd;
  odd.run.seed = 12345;
  odd.world.sight.range_m = 0.1 + 0.2;
  odd.world.obstacles.discs = {{1.0 / 3.0, 2.0, 3.0}};
  odd.brain.learner = "static1";
  EXPECT_EQ(printed(setup_of(printed(odd))), printed(odd));
}

}  // namespace
}  // namespace tacit
