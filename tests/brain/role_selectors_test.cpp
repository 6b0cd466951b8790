#include <gtest/gtest.h>

#include "idl/types/config_error.h"
#include "robot_agent/brain/learning/heterogeneous.h"
#include "robot_agent/brain/learning/homogeneous.h"
#include "tests/brain/forage_surroundings.h"

namespace tacit {
namespace {

using testing::disabled;
using testing::enemy;
using testing::ForageEyes;
using testing::mine;

TriggerSet triggers(std::vector<Sighting> sightings) {
  ForageEyes eyes;
  return role_triggers(eyes.look(std::move(sightings)), {});
}

TEST(RoleTriggers, AreFalseWhenNeitherEnemyNorDisabledRobotIsSeen) {
  EXPECT_EQ(words(triggers({mine(1, 0)})), "");
}

TEST(RoleTriggers, TellAnEnemyFromAnInvasion) {
  EXPECT_EQ(words(triggers({enemy(5.1, 0)})), "DetectEnemy");
  EXPECT_EQ(words(triggers({enemy(5, 0)})), "DetectEnemy+IsInvasion");
}

TEST(RoleTriggers, TellADisabledRobotFromADieOff) {
  EXPECT_EQ(words(triggers({disabled(5.1, 0)})), "DetectDead");
  EXPECT_EQ(words(triggers({disabled(5, 0)})), "DetectDead+IsDieOff");
}

TEST(RoleTriggers, HaveTheirBitsInThePapersOrder) {
  EXPECT_EQ(triggers({enemy(9, 0)}).bits, 1);
  EXPECT_EQ(triggers({enemy(1, 0)}).bits, 3);
  EXPECT_EQ(triggers({disabled(9, 0)}).bits, 4);
  EXPECT_EQ(triggers({disabled(1, 0)}).bits, 12);
}

TEST(RoleTriggers, MakeFortyEightInternalStatesOfWhichTwentySevenAreFeasible) {
  std::size_t count = 0;
  for (std::size_t state = 0; state < kInternalStates; ++state) {
    if (feasible(triggers_in(state))) ++count;
  }
  EXPECT_EQ(kInternalStates, 48U);
  EXPECT_EQ(count, 27U);
}

TEST(RoleTriggers, AndRoleMakeTheIndexOfAnInternalState) {
  EXPECT_EQ(internal_state({5}, Role::Mechanic), 2U + 3U * 5U);
  EXPECT_EQ(role_in(17), Role::Mechanic);
  EXPECT_EQ(triggers_in(17), TriggerSet{5});
}

TEST(RoleTriggers, AreReadBackFromTheirWords) {
  for (std::uint8_t bits = 0; bits < kTriggerSets; ++bits) {
    EXPECT_EQ(triggers_in(std::string_view(words({bits}))), TriggerSet{bits});
  }
  EXPECT_FALSE(triggers_in(std::string_view("IsInvasion+DetectEnemy")).has_value());
}

Role chosen(RoleSelector& selector, std::vector<Sighting> sightings) {
  ForageEyes eyes;
  const Surroundings& around = eyes.look(std::move(sightings));
  return selector.choose({around, role_triggers(around, {})});
}

TEST(Homogeneous, ForagesByDefault) {
  Homogeneous selector;
  EXPECT_EQ(chosen(selector, {mine(1, 0)}), Role::Forager);
}

TEST(Homogeneous, IsASoldierInThePresenceOfAnEnemy) {
  Homogeneous selector;
  EXPECT_EQ(chosen(selector, {mine(1, 0), enemy(40, 0)}), Role::Soldier);
}

TEST(Homogeneous, IsAMechanicWhenADisabledRobotIsSeen) {
  Homogeneous selector;
  EXPECT_EQ(chosen(selector, {mine(1, 0), disabled(40, 0)}), Role::Mechanic);
}

TEST(Homogeneous, PutsTheEnemyFirst) {
  Homogeneous selector;
  EXPECT_EQ(chosen(selector, {disabled(1, 0), enemy(40, 0)}), Role::Soldier);
}

std::string team(const Heterogeneous::Config& config, std::uint16_t robots) {
  std::string initials;
  for (std::uint16_t robot = 1; robot <= robots; ++robot) {
    Heterogeneous selector(config, RobotId{robot});
    initials += name(chosen(selector, {enemy(1, 0), disabled(1, 0)})).front();
  }
  return initials;
}

TEST(Heterogeneous, LaysItsPatternOverTheRobotsNumbers) {
  EXPECT_EQ(team({}, 10), "FFSMFFSMFF");
  EXPECT_EQ(team({.foragers = 0, .soldiers = 2, .mechanics = 1}, 7), "SSMSSMS");
}

TEST(Heterogeneous, IsRefusedWithAnEmptyPattern) {
  EXPECT_THROW(Heterogeneous({.foragers = 0, .soldiers = 0, .mechanics = 0}, RobotId{1}),
               ConfigError);
}

TEST(RoleSelector, ThatLearnsNothingInheritsItsOwnPolicyAlone) {
  Homogeneous homogeneous;
  Heterogeneous heterogeneous({}, RobotId{1});
  EXPECT_NO_THROW(homogeneous.inherit(homogeneous.policy(), "one"));
  try {
    homogeneous.inherit(heterogeneous.policy(), "one.json");
    FAIL();
  } catch (const ConfigError& error) {
    EXPECT_STREQ(error.what(),
                 "one.json: is not a policy of learner homogeneous: found "
                 "{\"learner\":\"heterogeneous\"}, wanted {\"learner\":\"homogeneous\"}");
  }
}

}  // namespace
}  // namespace tacit
