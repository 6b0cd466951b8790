#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "deploy/experiment/battery.h"
#include "idl/types/config_error.h"
#include "tests/experiment/small_battery.h"

namespace tacit {
namespace {

std::set<std::string> keys(const Battery& battery) {
  std::set<std::string> keys;
  for (const PlannedRun& run : battery.runs()) {
    keys.insert(run.key);
  }
  return keys;
}

bool share_none(const std::set<std::string>& a, const std::set<std::string>& b) {
  return std::none_of(a.begin(), a.end(), [&b](const std::string& key) { return b.contains(key); });
}

std::string joined(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) {
    text += (text.empty() ? "" : " ") + word;
  }
  return text;
}

/// Two scenarios, two variants, two strategies, a rival, two team sizes.
ExperimentConfig a_cross() {
  ExperimentConfig config;
  config.scenarios = {"guard", "crowd"};
  config.factors = {"enemies.strategy = 1, 5"};
  config.variants = {"slow: enemies.speed_mps = 1.0; robots.max_speed_mps = 1.5",
                     "fast: enemies.speed_mps = 2.0"};
  config.rivals = {"fixed: brain.learner = static1"};
  config.teams = {{1, 2}, {2, 2}};
  return config;
}

TEST(Planning, CrossesScenariosVariantsFactorsAndTeams) {
  const Battery battery = small_battery(a_cross());
  const auto own = std::count_if(battery.cells().begin(), battery.cells().end(),
                                 [](const Cell& cell) { return !cell.rival; });
  EXPECT_EQ(own, 2 * 2 * 2 * 2);
}

TEST(Planning, CrossesRivalsWithScenariosAndTeamsAlone) {
  const Battery battery = small_battery(a_cross());
  std::set<std::string> rivals;
  for (const Cell& cell : battery.cells()) {
    if (cell.rival) {
      rivals.insert(cell.level("scenario") + cell.level("variant") + std::to_string(cell.robots));
      EXPECT_EQ(cell.level("enemies.strategy"), "");
    }
  }
  EXPECT_EQ(rivals,
            (std::set<std::string>{"guardfixed1", "guardfixed2", "crowdfixed1", "crowdfixed2"}));
}

TEST(Planning, SetsAllThatAVariantNames) {
  const Battery battery = small_battery(a_cross());
  const Cell& slow = battery.cells().front();
  ASSERT_EQ(slow.level("variant"), "slow");
  const std::string text = battery.scenario(slow, 1);
  EXPECT_NE(text.find("\nspeed_mps = 1.0\n"), std::string::npos);
  EXPECT_NE(text.find("\nmax_speed_mps = 1.5\n"), std::string::npos);
}

TEST(Planning, TakesEachCellFromItsOwnScenario) {
  const Battery battery = small_battery(a_cross());
  for (const Cell& cell : battery.cells()) {
    const std::string name = "\nname = \"" + cell.level("scenario") + "\"\n";
    EXPECT_NE(battery.scenario(cell, 1).find(name), std::string::npos) << name;
  }
}

TEST(Planning, RefusesNamesThatAreThereTwice) {
  ExperimentConfig config = a_cross();
  config.variants.emplace_back("fixed: enemies.speed_mps = 1.1");
  EXPECT_THROW((void)small_battery(config), ConfigError);
  config = a_cross();
  config.scenarios = {"guard", "guard"};
  EXPECT_THROW((void)small_battery(config), ConfigError);
}

TEST(Planning, RefusesAVariantOfAParameterThatIsNone) {
  ExperimentConfig config = a_cross();
  config.variants.emplace_back("odd: enemies.sped_mps = 1.1");
  EXPECT_THROW((void)small_battery(config), ConfigError);
}

TEST(Planning, LetsVariantsAndScenariosBeCompared) {
  ExperimentConfig config = a_cross();
  for (const char* factor : {"variant", "scenario"}) {
    config.compare = factor;
    EXPECT_NO_THROW((void)small_battery(config)) << factor;
  }
}

TEST(Planning, GivesChainsSeedsOfTheirOwn) {
  const Battery battery = small_battery(small_contest());
  std::set<std::int64_t> seeds;
  for (const PlannedRun& run : battery.runs()) {
    seeds.insert(run.seed);
  }
  EXPECT_EQ(seeds, (std::set<std::int64_t>{1, 5, 9}));
}

TEST(Planning, TellsChainsOfOtherLengthsApart) {
  ExperimentConfig longer = small_contest();
  longer.episodes = 5;
  ExperimentConfig counting_more = small_contest();
  counting_more.evaluate = 3;
  const std::set<std::string> mine = keys(small_battery(small_contest()));
  EXPECT_TRUE(share_none(mine, keys(small_battery(longer))));
  EXPECT_TRUE(share_none(mine, keys(small_battery(counting_more))));
}

TEST(Planning, GivesSingleRunsTheKeysTheyAlwaysHad) {
  const Battery battery = small_battery();
  const PlannedRun& run = battery.runs().front();
  const std::string scenario = battery.scenario(battery.cells()[run.cell], run.seed);
  EXPECT_EQ(run.key, repeatable_key(scenario, run.seed, "1.0"));
}

TEST(Planning, NamesTheCommandThatMakesAChainAgain) {
  const Battery battery = small_battery(small_contest());
  EXPECT_EQ(joined(battery.command(battery.cells().front(), 5)),
            "tacit learn guard --episodes 4 --evaluate 2 --one-process --set run.duration_s=5 "
            "--set obstacles.coverage_percent=0 --set enemies.speed_mps=1.5 --set robots.count=2 "
            "--set run.seed=5 --json");
}

TEST(Planning, NamesTheCommandThatMakesARunAgain) {
  const Battery battery = small_battery();
  const std::string command = joined(battery.command(battery.cells().front(), 11));
  EXPECT_EQ(command.find("tacit run guard --one-process --set run.duration_s=20 "), 0U) << command;
}

}  // namespace
}  // namespace tacit
