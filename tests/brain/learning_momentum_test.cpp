#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "idl/types/config_error.h"
#include "robot_agent/brain/brain_config.h"
#include "robot_agent/brain/learning/learning_momentum.h"
#include "tests/brain/percepts.h"

namespace tacit {
namespace {

using testing::seen;

// Typed from the paper, apart from the code's own table.
struct PaperRow {
  Situation situation;
  double move_to_target;
  double intercept;
  double avoid_soldiers;
};
constexpr PaperRow kPaper[] = {
    {Situation::AllClear, 0.05, -0.05, 0.05},
    {Situation::FlankingEnemy, -0.1, 0.1, -0.1},
    {Situation::ClearToEnemy, -0.1, 0.1, 0.1},
    {Situation::SoldierNeedsHelp, -0.1, 0.1, -0.1},
    {Situation::NoSoldiersNeedHelp, 0.1, -0.1, -0.1},
};

LearningMomentum::Config roomy() {
  LearningMomentum::Config config;
  config.initial.of<MoveToTarget>() = 5.0;
  config.initial.of<InterceptEnemies>() = 5.0;
  config.initial.of<AvoidSoldiers>() = 5.0;
  config.initial.of<AvoidObstacles>() = 1.0;
  config.min = {0.0, 0.0, 0.0};
  config.max = {10.0, 10.0, 10.0};
  return config;
}

LearningMomentum::Config bounded() {
  LearningMomentum::Config config;
  config.initial.of<MoveToTarget>() = 1.0;
  config.initial.of<InterceptEnemies>() = 0.5;
  config.initial.of<AvoidSoldiers>() = 0.3;
  config.min = {0.4, 0.1, 0.1};
  config.max = {1.0, 1.0, 0.6};
  return config;
}

/// Surroundings that are of the given situation.
Surroundings surroundings(Situation situation, Tick tick) {
  Surroundings around;
  around.tick = tick;
  if (situation == Situation::AllClear) return around;
  const bool many = situation == Situation::SoldierNeedsHelp;
  around.groups.push_back({many ? 3U : 2U, {20.0, 0.0}, seen(20.0, 0.0)});
  around.target_m = BodyVec{situation == Situation::ClearToEnemy ? -10.0 : 10.0, 0.0};
  if (situation == Situation::ClearToEnemy || situation == Situation::FlankingEnemy) {
    around.open_group = &around.groups.front();
  } else {
    around.teammates.push_back(seen(10.0, 0.0));
  }
  return around;
}

void learn(LearningMomentum& lm, Situation situation, Tick tick) {
  lm.learn(surroundings(situation, tick));
}

LearningMomentum make(const LearningMomentum::Config& config) {
  return {config, SituationConfig{}, Occlusion(Occlusion::Config{})};
}

class Table1 : public ::testing::TestWithParam<PaperRow> {};

TEST_P(Table1, ShiftsTheThreeGainsByThePapersRow) {
  LearningMomentum lm = make(roomy());

  learn(lm, GetParam().situation, 10);

  EXPECT_EQ(lm.situation(), name(GetParam().situation));
  EXPECT_DOUBLE_EQ(lm.gains().of<MoveToTarget>(), 5.0 + GetParam().move_to_target);
  EXPECT_DOUBLE_EQ(lm.gains().of<InterceptEnemies>(), 5.0 + GetParam().intercept);
  EXPECT_DOUBLE_EQ(lm.gains().of<AvoidSoldiers>(), 5.0 + GetParam().avoid_soldiers);
}

TEST_P(Table1, LeavesTheOtherGainsAlone) {
  LearningMomentum lm = make(roomy());

  learn(lm, GetParam().situation, 10);

  EXPECT_EQ(lm.gains().of<AvoidObstacles>(), 1.0);
  EXPECT_EQ(lm.gains().of<Noise>(), 0.0);
}

TEST_P(Table1, NeverLeavesTheBounds) {
  const LearningMomentum::Config config = learning_momentum_config();
  LearningMomentum lm = make(config);

  for (Tick tick = 10; tick <= 1000; tick += 10) {
    learn(lm, GetParam().situation, tick);
    ASSERT_GE(lm.gains().of<MoveToTarget>(), config.min.move_to_target);
    ASSERT_LE(lm.gains().of<MoveToTarget>(), config.max.move_to_target);
    ASSERT_GE(lm.gains().of<InterceptEnemies>(), config.min.intercept);
    ASSERT_LE(lm.gains().of<InterceptEnemies>(), config.max.intercept);
    ASSERT_GE(lm.gains().of<AvoidSoldiers>(), config.min.avoid_soldiers);
    ASSERT_LE(lm.gains().of<AvoidSoldiers>(), config.max.avoid_soldiers);
  }
}

INSTANTIATE_TEST_SUITE_P(Paper, Table1, ::testing::ValuesIn(kPaper),
                         [](const auto& row) { return std::string(name(row.param.situation)); });

TEST(LearningMomentum, StartsFromTheInitialGains) {
  LearningMomentum lm = make(roomy());

  learn(lm, Situation::AllClear, 0);

  EXPECT_EQ(lm.gains(), roomy().initial);
  EXPECT_EQ(lm.situation(), "");
}

TEST(LearningMomentum, AdaptsAtMultiplesOfThePeriodOnly) {
  LearningMomentum lm = make(roomy());

  std::vector<Tick> adapted;
  for (Tick tick = 0; tick <= 30; ++tick) {
    const Gains before = lm.gains();
    learn(lm, Situation::AllClear, tick);
    if (!(lm.gains() == before)) adapted.push_back(tick);
  }

  EXPECT_EQ(adapted, (std::vector<Tick>{10, 20, 30}));
}

TEST(LearningMomentum, CatchesUpOnceWhenTheTickWasMissed) {
  LearningMomentum lm = make(roomy());

  learn(lm, Situation::AllClear, 23);
  learn(lm, Situation::AllClear, 24);

  EXPECT_DOUBLE_EQ(lm.gains().of<MoveToTarget>(), 5.05);
}

TEST(LearningMomentum, RefusesInitialGainsOutsideTheBounds) {
  LearningMomentum::Config config = roomy();
  config.max.intercept = 4.0;

  EXPECT_THROW(make(config), ConfigError);
}

TEST(LearningMomentum, RemembersItsGainsToTheBit) {
  LearningMomentum teacher = make(roomy());
  for (Tick tick = 10; tick <= 70; tick += 10) learn(teacher, Situation::ClearToEnemy, tick);
  LearningMomentum pupil = make(roomy());

  ASSERT_TRUE(pupil.recall(teacher.memory()));

  EXPECT_EQ(pupil.gains(), teacher.gains());
}

TEST(LearningMomentum, WritesItsMemoryAsOneLineOfJson) {
  EXPECT_EQ(make(bounded()).memory(),
            R"({"learner":"lm","move_to_target":1,"intercept_enemies":0.5,"avoid_soldiers":0.3})");
}

class MalformedMemory : public ::testing::TestWithParam<const char*> {};

TEST_P(MalformedMemory, IsRefusedAndChangesNothing) {
  LearningMomentum lm = make(bounded());
  const Gains before = lm.gains();

  EXPECT_FALSE(lm.recall(GetParam()));
  EXPECT_EQ(lm.gains(), before);
}

INSTANTIATE_TEST_SUITE_P(
    Texts, MalformedMemory,
    ::testing::Values(
        "", "{}", "{\"learner\":\"lm\"}", "{\"learner\":\"static1\"}",
        R"({"learner":"lm","move_to_target":0.9,"intercept_enemies":0.5})",
        R"({"learner":"lm","move_to_target":0.9,"intercept_enemies":0.5,"avoid_soldiers":0.3)",
        R"({"learner":"lm","move_to_target":0.9,"intercept_enemies":0.5,"avoid_soldiers":0.3}})",
        R"( {"learner":"lm","move_to_target":0.9,"intercept_enemies":0.5,"avoid_soldiers":0.3})",
        R"({"learner":"lm","move_to_target":0.90,"intercept_enemies":0.5,"avoid_soldiers":0.3})",
        R"({"learner":"lm","move_to_target":nan,"intercept_enemies":0.5,"avoid_soldiers":0.3})",
        R"({"learner":"lm","move_to_target":inf,"intercept_enemies":0.5,"avoid_soldiers":0.3})",
        R"({"learner":"lm","move_to_target":"1","intercept_enemies":0.5,"avoid_soldiers":0.3})",
        R"({"learner":"lm","move_to_target":0.39,"intercept_enemies":0.5,"avoid_soldiers":0.3})",
        R"({"learner":"lm","move_to_target":0.9,"intercept_enemies":1.01,"avoid_soldiers":0.3})",
        R"({"learner":"lm","intercept_enemies":0.5,"move_to_target":0.9,"avoid_soldiers":0.3})"));

}  // namespace
}  // namespace tacit
