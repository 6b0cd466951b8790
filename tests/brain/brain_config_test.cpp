#include "robot_agent/brain/brain_config.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>

#include "idl/types/config_error.h"
#include "robot_agent/brain/brain.h"

namespace tacit {
namespace {

/// Notes what a description says of each parameter.
class Notes final : public ParameterVisitor {
 public:
  struct Note {
    bool in_range = true;
    std::string doc;
  };

  void section(std::string_view name, std::string_view doc) override {
    section_ = name;
    EXPECT_TRUE(name == "brain" || name.starts_with("brain.")) << name;
    EXPECT_TRUE(doc.ends_with('.')) << name;
    ++sections[section_];
  }
  void number(std::string_view key, double& value, Range range, ParameterDoc doc) override {
    note(key, {value >= range.min && value <= range.max && std::isfinite(range.max),
               std::string(doc.doc)});
  }
  void integer(std::string_view key, std::int64_t& value, Range range, ParameterDoc doc) override {
    double number_value = static_cast<double>(value);
    number(key, number_value, range, doc);
  }
  void flag(std::string_view key, bool& /*value*/, ParameterDoc doc) override {
    note(key, {true, std::string(doc.doc)});
  }
  void choice(std::string_view key, std::string& value, std::span<const std::string_view> choices,
              ParameterDoc doc) override {
    note(key,
         {std::find(choices.begin(), choices.end(), value) != choices.end(), std::string(doc.doc)});
  }
  void rows(std::string_view key, std::vector<std::vector<double>>& /*value*/,
            std::span<const std::string_view> /*columns*/, Range /*range*/,
            ParameterDoc doc) override {
    note(key, {true, std::string(doc.doc)});
  }
  void text(std::string_view key, std::string& /*value*/, ParameterDoc doc) override {
    note(key, {true, std::string(doc.doc)});
  }
  void texts(std::string_view key, std::vector<std::string>& /*value*/, ParameterDoc doc) override {
    note(key, {true, std::string(doc.doc)});
  }

  std::multimap<std::string, Note> notes;
  std::map<std::string, int> sections;

 private:
  void note(std::string_view key, Note note) {
    notes.emplace(section_ + "." + std::string(key), std::move(note));
  }
  std::string section_;
};

Notes noted(MissionKind mission = MissionKind::Guard) {
  BrainConfig config = brain_defaults(mission);
  Notes notes;
  describe(config, notes);
  return notes;
}

class EveryMission : public ::testing::TestWithParam<MissionKind> {};

INSTANTIATE_TEST_SUITE_P(BrainConfig, EveryMission,
                         ::testing::Values(MissionKind::Guard, MissionKind::Forage),
                         [](const auto& mission) { return std::string(name(mission.param)); });

TEST_P(EveryMission, DescribesEachParameterOnce) {
  const Notes found = noted(GetParam());
  for (const auto& [name, note] : found.notes) EXPECT_EQ(found.notes.count(name), 1U) << name;
  for (const auto& [name, count] : found.sections) EXPECT_EQ(count, 1) << name;
}

TEST_P(EveryMission, HasDefaultsWithinTheirRanges) {
  const Notes found = noted(GetParam());
  for (const auto& [name, note] : found.notes) EXPECT_TRUE(note.in_range) << name;
}

TEST_P(EveryMission, NamesTheSourceOfEveryParameter) {
  const Notes found = noted(GetParam());
  for (const auto& [name, note] : found.notes) {
    const bool sourced = note.doc.ends_with("[paper].") || note.doc.ends_with("[MissionLab].") ||
                         note.doc.find("[ours: ") != std::string::npos;
    EXPECT_TRUE(sourced && note.doc.ends_with("].")) << name << ": " << note.doc;
  }
}

TEST(BrainConfig, DescribesAGainPerSchemaAndAssemblage) {
  const Notes found = noted();
  for (const char* section :
       {"brain.static1", "brain.static2", "brain.crowd", "brain.lm.initial"}) {
    for_each_schema([&]<class S>() {
      const std::string name = std::string(section) + "." + std::string(S::kKey);
      EXPECT_EQ(found.notes.count(name), 1U) << name;
    });
  }
}

std::set<std::string> sections(MissionKind mission) {
  std::set<std::string> names;
  for (const auto& [name, count] : noted(mission).sections) names.insert(name);
  return names;
}

TEST(BrainConfig, DescribesTheSectionsOfItsMissionAlone) {
  EXPECT_EQ(
      sections(MissionKind::Guard),
      (std::set<std::string>{
          "brain", "brain.actuator", "brain.avoid_obstacles", "brain.avoid_soldiers", "brain.crowd",
          "brain.enemy_groups", "brain.intercept_enemies", "brain.lm", "brain.lm.initial",
          "brain.lm.max", "brain.lm.min", "brain.move_to_target", "brain.noise", "brain.occlusion",
          "brain.situation", "brain.static1", "brain.static2"}));
  EXPECT_EQ(
      sections(MissionKind::Forage),
      (std::set<std::string>{"brain", "brain.actuator", "brain.avoid_obstacles",
                             "brain.avoid_soldiers", "brain.heterogeneous", "brain.noise",
                             "brain.pursue_enemy", "brain.q", "brain.q.rewards", "brain.roles"}));
}

TEST(BrainConfig, LetsTheStaticSoldiersDifferInMoveToTargetAlone) {
  Gains static1 = static1_gains();
  EXPECT_LT(static1.of<MoveToTarget>(), static2_gains().of<MoveToTarget>());
  static1.of<MoveToTarget>() = static2_gains().of<MoveToTarget>();
  EXPECT_EQ(static1, static2_gains());
}

std::string refusal(const BrainConfig& config) {
  try {
    const Brain brain(config, RobotId{1}, 0);
  } catch (const ConfigError& error) {
    return error.what();
  }
  return "accepted";
}

TEST(BrainConfig, IsAcceptedAsItIs) { EXPECT_EQ(refusal({}), "accepted"); }

TEST(BrainConfig, IsRefusedWithAnUnknownLearner) {
  BrainConfig config;
  config.learner = "static3";
  EXPECT_EQ(refusal(config), "brain.learner is static3, wanted one of static1 static2 lm crowd");
}

TEST(BrainConfig, IsRefusedWithANumberOutOfRange) {
  BrainConfig config;
  config.occlusion.angle_deg = -1.0;
  EXPECT_EQ(refusal(config), "brain.occlusion.angle_deg is -1 deg, wanted 0 to 180 deg");
}

TEST(BrainConfig, IsRefusedWithANumberThatIsNone) {
  BrainConfig config;
  config.actuator.max_mps = std::numeric_limits<double>::quiet_NaN();
  EXPECT_NE(refusal(config).find("brain.actuator.max_mps is nan"), std::string::npos);
}

TEST(BrainConfig, IsRefusedWithAPeriodOfZero) {
  BrainConfig config;
  config.lm.period_ticks = 0;
  EXPECT_NE(refusal(config).find("brain.lm.period_ticks is 0"), std::string::npos);
}

TEST(BrainConfig, IsRefusedWhenAMarginLiesBeyondReachAlsoOfAnUnusedSchema) {
  BrainConfig config;
  config.learner = "crowd";
  config.crowd.of<AvoidSoldiers>() = 0.0;
  config.of<AvoidSoldiers>().min_range_m = 80.0;
  EXPECT_EQ(refusal(config),
            "brain.avoid_soldiers: min_range_m is 80, wanted less than reach_m, which is 75");
}

TEST(BrainConfig, IsRefusedWhenALowerBoundLiesAboveTheInitialGain) {
  BrainConfig config;
  config.lm.min.move_to_target = 2.0;
  EXPECT_NE(refusal(config).find("brain.lm.initial.move_to_target is 1"), std::string::npos);
}

BrainConfig forage() { return brain_defaults(MissionKind::Forage); }

TEST(ForageConfig, IsAcceptedAsItIsWithEachOfItsLearners) {
  for (const std::string_view learner : kForageLearners) {
    BrainConfig config = forage();
    config.learner = learner;
    EXPECT_EQ(refusal(config), "accepted");
  }
}

TEST(ForageConfig, IsRefusedWithALearnerOfGuards) {
  BrainConfig config = forage();
  config.learner = "lm";
  EXPECT_EQ(refusal(config), "brain.learner is lm, wanted one of q homogeneous heterogeneous");
}

TEST(ForageConfig, IsRefusedWithARateOutOfRangeOrNone) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (double QLearner::Config::*rate :
       {&QLearner::Config::alpha, &QLearner::Config::alpha_decay, &QLearner::Config::epsilon,
        &QLearner::Config::epsilon_decay, &QLearner::Config::gamma}) {
    for (const double value : {-0.1, 1.1, nan}) {
      BrainConfig config = forage();
      config.q.learner.*rate = value;
      EXPECT_TRUE(refusal(config).starts_with("brain.q.")) << refusal(config);
    }
  }
}

TEST(ForageConfig, IsRefusedWithRewardsAndInitialValuesThatAreNone) {
  BrainConfig config = forage();
  config.q.rewards.aid = std::numeric_limits<double>::infinity();
  EXPECT_EQ(refusal(config), "brain.q.rewards.aid is inf, wanted -1e+06 to 1e+06");
  config = forage();
  config.q.learner.initial_low = 3.0;
  EXPECT_EQ(refusal(config),
            "brain.q.initial_low is 3, wanted at most brain.q.initial_high, which is 2");
}

TEST(ForageConfig, IsRefusedWithATimeOutOfZero) {
  BrainConfig config = forage();
  config.q.action_timeout_ticks = 0;
  EXPECT_TRUE(refusal(config).starts_with("brain.q.action_timeout_ticks is 0"));
}

TEST(ForageConfig, IsRefusedWithAnEmptyPatternAlsoOfAnUnusedLearner) {
  BrainConfig config = forage();
  config.heterogeneous = {.foragers = 0, .soldiers = 0, .mechanics = 0};
  EXPECT_TRUE(refusal(config).starts_with("brain.heterogeneous: "));
}

TEST(ForageConfig, IsRefusedWhenASchemaOfARoleCannotBe) {
  BrainConfig config = forage();
  config.of<AvoidObstacles>().margin_m = 2.0;
  EXPECT_NE(refusal(config).find("brain.avoid_obstacles: margin_m is 2"), std::string::npos);
}

TEST(ForageConfig, IsRefusedWhenNearLiesBeyondReach) {
  BrainConfig config = forage();
  config.roles.near_base_m = 1.5;
  EXPECT_TRUE(refusal(config).starts_with("brain.roles.near_base_m is 1.5 m"));
}

}  // namespace
}  // namespace tacit
