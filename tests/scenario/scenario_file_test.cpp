#include "idl/scenario/scenario_file.h"

#include <gtest/gtest.h>

#include "idl/scenario/run_config.h"
#include "tests/scenario/sample_config.h"

namespace tacit {
namespace {

TEST(ScenarioFile, GivesEachNamedParameterItsValue) {
  const SampleConfig config = loaded(
      "[robots]\nradius_m = 0.5\ncount = 3\nwalls = false\n"
      "[robots.brain]\nlearner = \"static2\"\nnote = \"hello\"\ndiscs = [[1, 2.5, 3]]\n");
  EXPECT_EQ(config.radius_m, 0.5);
  EXPECT_EQ(config.count, 3);
  EXPECT_FALSE(config.walls);
  EXPECT_EQ(config.learner, "static2");
  EXPECT_EQ(config.note, "hello");
  EXPECT_EQ(config.discs, (std::vector<std::vector<double>>{{1.0, 2.5, 3.0}}));
}

TEST(ScenarioFile, LeavesUnnamedParametersAsTheyWere) {
  const SampleConfig config = loaded("[robots]\ncount = 2\n");
  EXPECT_EQ(config.radius_m, 0.25);
  EXPECT_EQ(config.learner, "lm");
}

TEST(ScenarioFile, TakesAWholeNumberWhereANumberIsWanted) {
  EXPECT_EQ(loaded("[robots]\nradius_m = 2\n").radius_m, 2.0);
}

TEST(ScenarioFile, AcceptsBothEndsOfARange) {
  EXPECT_EQ(complaint("[robots]\nradius_m = 0.05\ncount = 1000\n"), "");
}

TEST(ScenarioFile, NamesFileLineKeyValueAndRangeOfANumberOutOfRange) {
  EXPECT_EQ(complaint("[robots]\nradius_m = -0.5\n"),
            "team.toml:2:12: [robots] radius_m = -0.5: found -0.5, wanted a number of 0.05 to 5 "
            "(m)");
}

TEST(ScenarioFile, NamesFileLineKeyValueAndRangeOfAWholeNumberOutOfRange) {
  EXPECT_EQ(complaint("\n[robots]\n  count = 0\n"),
            "team.toml:3:11: [robots] count = 0: found 0, wanted a whole number of 1 to 1000");
}

TEST(ScenarioFile, RefusesAFractionWhereAWholeNumberIsWanted) {
  EXPECT_EQ(complaint("[robots]\ncount = 2.0\n"),
            "team.toml:2:9: [robots] count = 2.0: found 2.0, wanted a whole number of 1 to 1000");
}

TEST(ScenarioFile, RefusesTextWhereANumberIsWanted) {
  EXPECT_EQ(complaint("[robots]\nradius_m = \"wide\"\n"),
            "team.toml:2:12: [robots] radius_m = \"wide\": found \"wide\", wanted a number of 0.05 "
            "to 5 (m)");
}

TEST(ScenarioFile, RefusesNotANumber) {
  EXPECT_EQ(complaint("[robots]\nradius_m = nan\n"),
            "team.toml:2:12: [robots] radius_m = nan: found nan, wanted a number of 0.05 to 5 (m)");
}

TEST(ScenarioFile, RefusesInfinity) { EXPECT_NE(complaint("[robots]\nradius_m = inf\n"), ""); }

TEST(ScenarioFile, RefusesANumberWhereAFlagIsWanted) {
  EXPECT_EQ(complaint("[robots]\nwalls = 1\n"),
            "team.toml:2:9: [robots] walls = 1: found 1, wanted true or false");
}

TEST(ScenarioFile, HintsAtTheNearestChoice) {
  EXPECT_EQ(complaint("[robots.brain]\nlearner = \"statc1\"\n"),
            "team.toml:2:11: [robots.brain] learner = \"statc1\": found \"statc1\", wanted one of "
            "\"static1\", \"static2\", \"lm\", did you mean \"static1\"?");
}

TEST(ScenarioFile, RefusesANumberWhereTextIsWanted) {
  EXPECT_EQ(complaint("[robots.brain]\nnote = 7\n"),
            "team.toml:2:8: [robots.brain] note = 7: found 7, wanted text in quotes");
}

TEST(ScenarioFile, NamesTheRowThatHasTooFewNumbers) {
  EXPECT_EQ(complaint("[robots.brain]\ndiscs = [[1, 2, 3], [4, 5]]\n"),
            "team.toml:2:9: [robots.brain] discs = a list of rows whose row 2 does not fit: found "
            "a list of rows whose row 2 does not fit, wanted rows of 3 numbers [x, y, r] of 0 to "
            "100 (m)");
}

TEST(ScenarioFile, RefusesANumberOutOfRangeInARow) {
  EXPECT_NE(complaint("[robots.brain]\ndiscs = [[1, 2, 101]]\n"), "");
}

TEST(ScenarioFile, RefusesAListOfWordsWhereRowsAreWanted) {
  EXPECT_NE(complaint("[robots.brain]\ndiscs = [\"a\"]\n").find("wanted rows"), std::string::npos);
}

TEST(ScenarioFile, RefusesNumbersWhereTextsAreWanted) {
  EXPECT_NE(complaint("[robots.brain]\ntags = [[1]]\n").find("wanted a list of texts in quotes"),
            std::string::npos);
}

TEST(ScenarioFile, TakesAnEmptyListForNoTexts) {
  EXPECT_EQ(complaint("[robots.brain]\ntags = []\n"), "");
}

TEST(ScenarioFile, RefusesATableWhereANumberIsWanted) {
  EXPECT_NE(complaint("[robots.radius_m]\nx = 1\n").find("found a table, wanted a number"),
            std::string::npos);
}

TEST(ScenarioFile, HintsAtTheNearestKeyWhenAKeyIsUnknown) {
  EXPECT_EQ(complaint("[robots]\nraduis_m = 1\n"),
            "team.toml:2:1: [robots] has no key \"raduis_m\", did you mean \"radius_m\"?");
}

TEST(ScenarioFile, GivesNoHintWhenNoKeyIsNear) {
  EXPECT_EQ(complaint("[robots]\nzzz = 1\n"), "team.toml:2:1: [robots] has no key \"zzz\"");
}

TEST(ScenarioFile, HintsAtTheNearestSectionWhenASectionIsUnknown) {
  EXPECT_EQ(complaint("[robot]\ncount = 1\n"),
            "team.toml:1:2: there is no section [robot], did you mean \"robots\"?");
}

TEST(ScenarioFile, RefusesAnUnknownSectionInsideAKnownOne) {
  EXPECT_NE(complaint("[robots.brian]\n").find("no section [robots.brian], did you mean"),
            std::string::npos);
}

TEST(ScenarioFile, RefusesAKeyOutsideTheSections) {
  EXPECT_EQ(complaint("count = 1\n"),
            "team.toml:1:1: \"count\" stands outside the sections, wanted it below a [section]");
}

TEST(ScenarioFile, LeavesSectionsOfOthersAlone) {
  RunConfig run;
  ScenarioFile file = ScenarioFile::parse("[run]\nseed = 5\n[robots]\ncount = 2\n", "team.toml");
  file.fill(run);
  EXPECT_EQ(run.seed, 5);
}

TEST(ScenarioFile, NamesTheLineOfBrokenToml) {
  EXPECT_EQ(complaint("[robots]\ncount = = 2\n").rfind("team.toml:2:9: ", 0), 0U);
}

TEST(ScenarioFile, RefusesTheSameKeyTwice) {
  EXPECT_EQ(complaint("[robots]\ncount = 1\ncount = 2\n").rfind("team.toml:3:", 0), 0U);
}

TEST(ScenarioFile, NamesAFileThatIsNotThere) {
  try {
    (void)ScenarioFile::read("/nowhere/team.toml");
    FAIL();
  } catch (const ConfigError& error) {
    EXPECT_STREQ(error.what(), "/nowhere/team.toml: cannot be read, wanted a scenario file (TOML)");
  }
}

TEST(ScenarioFileSet, StandsInForTheFilesValue) {
  ScenarioFile file = ScenarioFile::parse("[robots]\ncount = 2\n", "team.toml");
  file.set("robots.count", "9");
  SampleConfig config;
  file.fill(config);
  EXPECT_EQ(config.count, 9);
}

TEST(ScenarioFileSet, TakesWordsWithoutQuotes) {
  ScenarioFile file = ScenarioFile::parse("", "team.toml");
  file.set("robots.brain.learner", "static2");
  SampleConfig config;
  file.fill(config);
  EXPECT_EQ(config.learner, "static2");
}

TEST(ScenarioFileSet, NamesItselfAsThePlaceOfAWrongValue) {
  EXPECT_EQ(complaint("", "robots.count", "many"),
            "--set: [robots] count = \"many\": found \"many\", wanted a whole number of 1 to 1000");
}

TEST(ScenarioFileSet, NamesItsGiverAsThePlaceOfAWrongValue) {
  ScenarioFile file = ScenarioFile::parse("", "team.toml");
  file.set("robots.count", "0", "--robots");
  SampleConfig config;
  try {
    file.fill(config);
    FAIL();
  } catch (const ConfigError& error) {
    EXPECT_STREQ(error.what(),
                 "--robots: [robots] count = 0: found 0, wanted a whole number of 1 to 1000");
  }
}

TEST(ScenarioFileSet, RefusesAnUnknownKey) {
  EXPECT_EQ(complaint("", "robots.cuont", "1"),
            "--set: [robots] has no key \"cuont\", did you mean \"count\"?");
}

TEST(ScenarioFileSet, RefusesAnUnknownSection) {
  EXPECT_EQ(complaint("", "robot.count", "1"),
            "--set: there is no section [robot], did you mean \"robots\"?");
}

TEST(ScenarioFileSet, RefusesAPathWithoutSection) {
  EXPECT_EQ(complaint("", "count", "1"), "--set: found \"count\", wanted section.key=value");
}

TEST(ScenarioFile, KnowsWhichTablesItHolds) {
  const ScenarioFile file = ScenarioFile::parse("[robots.brain]\n", "team.toml");
  EXPECT_TRUE(file.has("robots"));
  EXPECT_TRUE(file.has("robots.brain"));
  EXPECT_FALSE(file.has("run"));
}

TEST(RunConfig, RefusesANegativeDuration) {
  RunConfig run;
  ScenarioFile file = ScenarioFile::parse("[run]\nduration_s = -1\n", "team.toml");
  EXPECT_THROW(file.fill(run), ConfigError);
}

}  // namespace
}  // namespace tacit
