#include <gtest/gtest.h>

#include "idl/types/config_error.h"
#include "robot_agent/brain/brain.h"
#include "robot_agent/brain/learning/policy_table.h"
#include "tests/brain/percepts.h"

namespace tacit {
namespace {

BrainConfig forage() { return brain_defaults(MissionKind::Forage); }

std::string lived(Tick ticks) {
  Brain brain(forage(), RobotId{3}, 9);
  for (Tick tick = 0; tick < ticks; ++tick) {
    static_cast<void>(brain.decide(testing::busy_forage_percept(tick, 4)));
  }
  return brain.policy();
}

TEST(Inheritance, OfAPolicyDecaysTheRatesAndKeepsTheTable) {
  const PolicyTable before = parse_policy(lived(100), "p");
  Brain brain(forage(), RobotId{3}, 10);
  brain.inherit(to_text(before), "p");
  const PolicyTable after = parse_policy(brain.policy(), "p");
  EXPECT_EQ(after.table.q, before.table.q);
  EXPECT_EQ(after.table.visits, before.table.visits);
  EXPECT_DOUBLE_EQ(after.table.alpha, 0.09);
  EXPECT_EQ(after.table.runs, 2U);
}

TEST(Inheritance, IsRefusedFromAnotherRobotAndChangesNothing) {
  Brain brain(forage(), RobotId{2}, 10);
  const std::string before = brain.memory();
  try {
    brain.inherit(lived(100), "r3.json");
    FAIL();
  } catch (const ConfigError& error) {
    EXPECT_STREQ(error.what(), "r3.json: robot is 3, wanted 2");
  }
  EXPECT_THROW(brain.inherit("{", "r3.json"), ConfigError);
  EXPECT_EQ(brain.memory(), before);
}

TEST(Inheritance, OfAGuardIsItsMemory) {
  BrainConfig config;
  config.lm.period_ticks = 1;
  Brain first(config, RobotId{1}, 1);
  for (Tick tick = 0; tick < 5; ++tick) {
    static_cast<void>(first.decide(testing::busy_percept(tick, 2)));
  }
  Brain second(config, RobotId{1}, 1);
  ASSERT_NE(second.policy(), first.policy());
  second.inherit(first.policy(), "lm.json");
  EXPECT_EQ(second.policy(), first.policy());
  EXPECT_EQ(second.lessons(), 0U);
}

TEST(Inheritance, OfAnotherGuardsPolicyIsRefused) {
  BrainConfig config;
  config.learner = "static1";
  Brain fixed(config, RobotId{1}, 1);
  Brain learning({}, RobotId{1}, 1);
  try {
    learning.inherit(fixed.policy(), "one.json");
    FAIL();
  } catch (const ConfigError& error) {
    EXPECT_TRUE(std::string(error.what())
                    .starts_with("one.json: is not a policy of learner lm: found "
                                 "{\"learner\":\"static1\"}, wanted one like {\"learner\":\"lm\""));
  }
}

}  // namespace
}  // namespace tacit
