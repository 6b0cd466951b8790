#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "tests/process/programs.h"

namespace tacit {
namespace {

namespace fs = std::filesystem;

/// A wrong call of `tacit run` and what it must say.
struct Mistake {
  std::string name;
  std::vector<std::string> arguments;
  std::string said;
};

std::vector<Mistake> mistakes() {
  return {
      {"ZeroRobots",
       {"guard", "--robots", "0"},
       "--robots: [robots] count = 0: found 0, wanted a whole number of 1 to "},
      {"WordsForANumber", {"guard", "--robots", "many"}, "found \"many\", wanted a whole number"},
      {"UnknownLearner",
       {"guard", "--learner", "statc1"},
       "--learner: [brain] learner = \"statc1\": found \"statc1\", wanted one of \"static1\""},
      {"UnknownStrategy", {"guard", "--strategy", "9"}, "wanted a whole number of 0 to 5"},
      {"NegativeRadius",
       {"guard", "--set", "robots.radius_m=-1"},
       "--set: [robots] radius_m = -1: found -1, wanted a number of "},
      {"UnknownKey",
       {"guard", "--set", "robots.raduis_m=1"},
       "[robots] has no key \"raduis_m\", did you mean \"radius_m\"?"},
      {"UnknownSection",
       {"guard", "--set", "robot.radius_m=1"},
       "there is no section [robot], did you mean \"robots\"?"},
      {"UnknownScenario", {"gaurd"}, "there is no scenario \"gaurd\", did you mean \"guard\"?"},
      {"MissingFile", {"/nowhere/x.toml"}, "/nowhere/x.toml: cannot be read"},
      {"NotANumber", {"guard", "--duration", "nan"}, "found nan, wanted a number"},
      {"NegativeSeed", {"guard", "--seed", "-1"}, "found -1, wanted a whole number of 0 to"},
      {"WrongSpeed",
       {"guard", "--speed", "fast"},
       "--speed: found \"fast\", wanted max or a number"},
      {"CoverageThatDoesNotFit",
       {"guard", "--set", "obstacles.coverage_percent=60", "--set", "obstacles.min_radius_m=40",
        "--set", "obstacles.max_radius_m=45", "--set", "obstacles.keep_free_m=60"},
       "obstacles"},
      {"StoreInAMissingFolder",
       {"guard", "--store", "/nowhere/runs.db"},
       "--store: there is no directory /nowhere"},
      {"UnknownOption", {"guard", "--robot", "3"}, "--robot"},
      {"NoMines", {"forage", "--set", "mines.count=0"}, "there are no mines; wanted at least 1"},
      {"MinesThatDoNotFit",
       {"forage", "--set", "mines.count=500", "--set", "mines.keep_from_base_m=41"},
       "mines"},
      {"RewardThatIsNoNumber",
       {"forage", "--set", "brain.q.rewards.mine=nan"},
       "found nan, wanted a number"},
      {"LearningRateAboveOne", {"forage", "--set", "brain.q.alpha=1.5"}, "found 1.5, wanted a"},
      {"ExplorationBelowZero", {"forage", "--set", "brain.q.epsilon=-0.1"}, "found -0.1, wanted"},
      {"LearnerOfAnotherMission",
       {"forage", "--learner", "lm"},
       "found \"lm\", wanted one of \"q\""},
      {"ParameterOfAnotherMission", {"forage", "--strategy", "1"}, "there is no section [enemies]"},
      {"UnknownMission",
       {"guard", "--set", "scenario.mission=forrage"},
       "found \"forrage\", wanted one of \"guard\""},
  };
}

std::string name_of(const testing::TestParamInfo<Mistake>& info) { return info.param.name; }

class BadInput : public testing::TestWithParam<Mistake> {};

TEST_P(BadInput, EndsWithTwoSaysWhatWasWantedAndMakesNothing) {
  const Scratch scratch;
  std::vector<std::string> words{"run"};
  words.insert(words.end(), GetParam().arguments.begin(), GetParam().arguments.end());
  words.emplace_back("--json");
  words.insert(words.end(), {"--out", scratch / "run"});
  const Finished finished = tacit(words);
  EXPECT_EQ(finished.exit_code, 2);
  EXPECT_NE(finished.err.find(GetParam().said), std::string::npos) << finished.err;
  EXPECT_EQ(finished.out, "");
  EXPECT_FALSE(fs::exists(scratch / "run"));
}

INSTANTIATE_TEST_SUITE_P(Mistakes, BadInput, testing::ValuesIn(mistakes()), name_of);

TEST(BadScenarioFile, IsNamedWithLineAndColumn) {
  const Scratch scratch;
  std::ofstream(scratch / "team.toml") << "[robots]\ncount = 3\nradius = 1\n";
  const Finished finished = tacit({"run", scratch / "team.toml", "--out", scratch / "run"});
  EXPECT_EQ(finished.exit_code, 2);
  EXPECT_NE(finished.err.find("team.toml:3:1: [robots] has no key \"radius\""), std::string::npos)
      << finished.err;
}

TEST(FileThatIsNoRunStore, IsRefusedBeforeTheRun) {
  const Scratch scratch;
  std::ofstream(scratch / "notes.txt") << "This is not a database, but long enough to be read.";
  const Finished finished = tacit({"run", "guard", "--one-process", "--out", scratch / "run",
                                   "--store", scratch / "notes.txt"});
  EXPECT_EQ(finished.exit_code, 2) << finished.err;
  EXPECT_NE(finished.err.find("notes.txt"), std::string::npos) << finished.err;
}

TEST(OccupiedRunDirectory, IsRefusedAndLeftAlone) {
  const Scratch scratch;
  fs::create_directory(scratch / "run");
  std::ofstream(scratch / "run/mine.txt") << "mine";
  for (const char* transport : {"--quiet", "--one-process"}) {
    const Finished finished = tacit({"run", "guard", transport, "--out", scratch / "run"});
    EXPECT_EQ(finished.exit_code, 2);
    EXPECT_NE(finished.err.find("occupied"), std::string::npos) << finished.err;
  }
  EXPECT_EQ(text_of(scratch / "run/mine.txt"), "mine");
  EXPECT_FALSE(fs::exists(scratch / "run/run.json"));
}

}  // namespace
}  // namespace tacit
