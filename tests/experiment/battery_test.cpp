#include "deploy/experiment/battery.h"

#include <gtest/gtest.h>

#include <set>

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

TEST(Battery, CrossesAllFactorsForEveryTeamSize) {
  const Battery battery = small_battery();
  std::set<std::string> seen;
  for (const Cell& cell : battery.cells()) {
    seen.insert(cell.levels[0].value + cell.levels[1].value + std::to_string(cell.robots));
  }
  EXPECT_EQ(seen, (std::set<std::string>{"static111", "static112", "static151", "static152", "lm11",
                                         "lm12", "lm51", "lm52"}));
}

TEST(Battery, GivesEveryCellTheSameSeedsSoThatTheyArePaired) {
  const Battery battery = small_battery();
  std::vector<std::set<std::int64_t>> seeds(battery.cells().size());
  for (const PlannedRun& run : battery.runs()) {
    seeds[run.cell].insert(run.seed);
  }
  for (std::size_t i = 0; i < seeds.size(); ++i) {
    const std::set<std::int64_t> wanted = battery.cells()[i].robots == 1
                                              ? std::set<std::int64_t>{11, 12}
                                              : std::set<std::int64_t>{11, 12, 13};
    EXPECT_EQ(seeds[i], wanted);
  }
}

TEST(Battery, GivesEveryRunAKeyOfItsOwn) {
  const Battery battery = small_battery();
  EXPECT_EQ(keys(battery).size(), battery.runs().size());
}

TEST(Battery, KeepsItsKeysFromOneSittingToTheNext) {
  EXPECT_EQ(keys(small_battery()), keys(small_battery()));
}

TEST(Battery, SharesNoKeyWithAnotherVersionOrSetting) {
  ExperimentConfig other = small_experiment();
  other.settings.emplace_back("enemies.speed_mps = 1.5");
  const std::set<std::string> mine = keys(small_battery());
  for (const std::set<std::string>& theirs :
       {keys(small_battery(small_experiment(), "1.1")), keys(small_battery(other))}) {
    for (const std::string& key : theirs) {
      EXPECT_FALSE(mine.contains(key));
    }
  }
}

TEST(Battery, WritesEverySettingIntoTheScenario) {
  const Battery battery = small_battery();
  const std::string text = battery.scenario(battery.cells().back(), 12);
  for (const char* line : {"\nseed = 12\n", "\nduration_s = 20.0\n", "\ncoverage_percent = 1.0\n",
                           "\nlearner = \"lm\"\n", "\nstrategy = 5\n", "\ncount = 2\n"}) {
    EXPECT_NE(text.find(line), std::string::npos) << line;
  }
}

TEST(Battery, RefusesAFactorThatNoParameterHasBeforeAnyRun) {
  ExperimentConfig config = small_experiment();
  config.factors.emplace_back("brain.lerner = lm, static1");
  EXPECT_THROW((void)small_battery(config), ConfigError);
}

TEST(Battery, RefusesToCompareWhatDoesNotVary) {
  ExperimentConfig config = small_experiment();
  config.compare = "robots.radius_m";
  EXPECT_THROW((void)small_battery(config), ConfigError);
}

}  // namespace
}  // namespace tacit
