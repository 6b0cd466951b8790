#include "deploy/experiment/experiment_config.h"

#include <gtest/gtest.h>

#include "deploy/experiment/levels.h"
#include "idl/scenario/scenario_file.h"
#include "idl/types/config_error.h"
#include "tests/experiment/small_battery.h"

namespace tacit {
namespace {

TEST(Factor, IsReadWithBlanksAnywhere) {
  const Factor factor = read_factor("  brain.learner=static1 ,lm,  static2 ");
  EXPECT_EQ(factor.path, "brain.learner");
  EXPECT_EQ(factor.values, (std::vector<std::string>{"static1", "lm", "static2"}));
}

TEST(Factor, IsRefusedWithoutAValueASectionOrBetweenTwoCommas) {
  for (const char* text : {"brain.learner", "brain.learner =", "learner = lm", "a.b = 1,,2", ""}) {
    EXPECT_THROW((void)read_factor(text), ConfigError) << text;
  }
}

TEST(Variant, IsReadWithBlanksAnywhere) {
  const Variant variant = read_variant(" 20/10 :brain.q.rewards.mine=20;  a.b = [1, 2] ");
  EXPECT_EQ(variant.name, "20/10");
  EXPECT_EQ(variant.settings,
            (std::vector<Setting>{{"brain.q.rewards.mine", "20"}, {"a.b", "[1, 2]"}}));
}

TEST(Variant, IsRefusedWithoutANameOrASetting) {
  for (const char* text : {"a.b = 1", ": a.b = 1", "name:", "name: a.b", "name: a.b = 1;", ""}) {
    EXPECT_THROW((void)read_variant(text), ConfigError) << text;
  }
}

TEST(ExperimentConfig, IsReadFromAFile) {
  ScenarioFile file = ScenarioFile::parse(
      "[experiment]\nscenarios = [\"a\", \"b\"]\nepisodes = 30\nevaluate = 5\n"
      "variants = [\"x: a.b = 1\"]\nrivals = [\"y: a.b = 2\"]\nselect_by = \"score_ticks\"\n"
      "held_out_runs = 20\nheld_out_first_seed = 77\n",
      "experiment.toml");
  ExperimentConfig config;
  file.fill(config);
  EXPECT_EQ(scenario_names(config), (std::vector<std::string>{"a", "b"}));
  EXPECT_EQ(config.episodes, 30);
  EXPECT_EQ(config.select_by, "score_ticks");
  EXPECT_EQ(config.held_out_first_seed, 77);
}

TEST(ExperimentConfig, EvaluatesAtMostAllEpisodes) {
  ExperimentConfig config;
  EXPECT_EQ(evaluated(config), 1);
  config.episodes = 30;
  EXPECT_EQ(evaluated(config), 5);
}

TEST(ExperimentConfig, TakesAContest) { EXPECT_NO_THROW(check(small_contest())); }

TEST(ExperimentConfig, RefusesToSelectByWhatIsNoMetric) {
  ExperimentConfig config = small_contest();
  config.select_by = "score_tick";
  EXPECT_THROW(check(config), ConfigError);
}

TEST(ExperimentConfig, RefusesToSelectWithoutRivals) {
  ExperimentConfig config = small_contest();
  config.rivals.clear();
  EXPECT_THROW(check(config), ConfigError);
}

TEST(ExperimentConfig, RefusesHeldOutRunsWithoutASelectionAndTheReverse) {
  ExperimentConfig config = small_contest();
  config.held_out_runs = 0;
  EXPECT_THROW(check(config), ConfigError);
  config = small_contest();
  config.select_by.clear();
  EXPECT_THROW(check(config), ConfigError);
}

// Training takes the seeds 1 to 12, held-out chains eight seeds from the first on.
TEST(ExperimentConfig, RefusesHeldOutSeedsThatTrainingHasSeen) {
  ExperimentConfig config = small_contest();
  config.held_out_first_seed = 12;
  EXPECT_THROW(check(config), ConfigError);
  config.held_out_first_seed = 13;
  EXPECT_NO_THROW(check(config));
  config.first_seed = 101;
  config.held_out_first_seed = 94;
  EXPECT_THROW(check(config), ConfigError);
  config.held_out_first_seed = 93;
  EXPECT_NO_THROW(check(config));
}

}  // namespace
}  // namespace tacit
