#include <gtest/gtest.h>

#include <algorithm>

#include "robot_agent/brain/brain.h"
#include "robot_agent/brain/learning/policy_table.h"
#include "tests/brain/forage_surroundings.h"

namespace tacit {
namespace {

using testing::base;
using testing::busy_forage_percept;
using testing::disabled;
using testing::enemy;
using testing::mine;
using testing::percept;

BrainConfig config_for(const char* learner) {
  BrainConfig config = brain_defaults(MissionKind::Forage);
  config.learner = learner;
  config.q.action_timeout_ticks = 17;
  return config;
}

Telemetry reported(const Brain& brain) {
  Telemetry telemetry;
  brain.report(telemetry);
  return telemetry;
}

bool equal(const Command& a, const Command& b) {
  return a.robot == b.robot && a.tick == b.tick && a.velocity_mps == b.velocity_mps &&
         a.turn_radps == b.turn_radps && a.act == b.act;
}

class ForageLaws : public ::testing::TestWithParam<const char*> {};

TEST_P(ForageLaws, ABrainThatRemembersDecidesAsOneThatNeverStopped) {
  const BrainConfig config = config_for(GetParam());
  for (Tick stop = 0; stop < 100; ++stop) {
    Brain whole(config, RobotId{2}, 5);
    for (Tick tick = 0; tick < stop; ++tick) {
      static_cast<void>(whole.decide(busy_forage_percept(tick, 3)));
    }
    Brain restarted(config, RobotId{2}, 5);
    ASSERT_TRUE(restarted.recall(whole.memory()));
    ASSERT_EQ(restarted.memory(), whole.memory());
    for (Tick tick = stop; tick < stop + 60; ++tick) {
      const Percept now = busy_forage_percept(tick, 3);
      ASSERT_TRUE(equal(restarted.decide(now), whole.decide(now))) << stop << ' ' << tick;
    }
    EXPECT_EQ(restarted.memory(), whole.memory());
    EXPECT_EQ(restarted.policy(), whole.policy());
  }
}

TEST_P(ForageLaws, TheMemoryHoldsThePolicyAsItWasGiven) {
  Brain brain(config_for(GetParam()), RobotId{2}, 5);
  for (Tick tick = 0; tick < 30; ++tick) {
    static_cast<void>(brain.decide(busy_forage_percept(tick, 3)));
  }
  EXPECT_EQ(brain.memory(brain.policy()), brain.memory());
  EXPECT_TRUE(brain.memory("a policy").ends_with("}\na policy"));
}

TEST_P(ForageLaws, TheOrderOfSightingsChangesNothingButRounding) {
  Brain straight(config_for(GetParam()), RobotId{2}, 5);
  Brain shuffled(config_for(GetParam()), RobotId{2}, 5);
  for (Tick tick = 0; tick < 200; ++tick) {
    Percept now = busy_forage_percept(tick, 3);
    const Command one = straight.decide(now);
    std::reverse(now.sightings.begin(), now.sightings.end());
    std::reverse(now.obstacles.begin(), now.obstacles.end());
    const Command two = shuffled.decide(now);
    EXPECT_NEAR(one.velocity_mps.x(), two.velocity_mps.x(), 1e-12);
    EXPECT_NEAR(one.velocity_mps.y(), two.velocity_mps.y(), 1e-12);
    EXPECT_EQ(one.act, two.act);
  }
}

TEST_P(ForageLaws, NoCommandIsFasterThanTheTopSpeed) {
  const BrainConfig config = config_for(GetParam());
  Brain brain(config, RobotId{2}, 5);
  for (Tick tick = 0; tick < 200; ++tick) {
    const Command command = brain.decide(busy_forage_percept(tick, 3));
    EXPECT_LE(command.velocity_mps.norm(), config.actuator.max_mps * (1.0 + 1e-12));
  }
}

TEST_P(ForageLaws, TheMemoryOfAnotherLearnerIsRefused) {
  const bool learns = std::string(GetParam()) == "q";
  Brain brain(config_for(GetParam()), RobotId{2}, 5);
  Brain other(config_for(learns ? "homogeneous" : "q"), RobotId{2}, 5);
  const std::string before = brain.memory();
  EXPECT_FALSE(brain.recall(other.memory()));
  EXPECT_EQ(brain.memory(), before);
}

INSTANTIATE_TEST_SUITE_P(Learners, ForageLaws,
                         ::testing::Values("q", "homogeneous", "heterogeneous"),
                         [](const auto& learner) { return std::string(learner.param); });

TEST(ForageBrain, RefusesAMemoryThatItDidNotWrite) {
  Brain brain(config_for("q"), RobotId{2}, 5);
  for (Tick tick = 0; tick < 30; ++tick) {
    static_cast<void>(brain.decide(busy_forage_percept(tick, 3)));
  }
  const std::string memory = brain.memory();
  Brain fresh(config_for("q"), RobotId{2}, 5);
  const std::string before = fresh.memory();
  EXPECT_FALSE(fresh.recall(""));
  EXPECT_FALSE(fresh.recall("\n"));
  EXPECT_FALSE(fresh.recall(memory.substr(0, memory.size() / 2)));
  EXPECT_FALSE(fresh.recall(memory.substr(1)));
  std::string newer = memory;
  newer.replace(newer.find("\"version\":1"), 11, "\"version\":2");
  EXPECT_FALSE(fresh.recall(newer));
  std::string elsewhere = memory;
  elsewhere.replace(elsewhere.find("\"state\":\"") + 9, 1, "?");
  EXPECT_FALSE(fresh.recall(elsewhere));
  EXPECT_EQ(fresh.memory(), before);
  EXPECT_FALSE(Brain(config_for("q"), RobotId{1}, 5).recall(memory));
}

TEST(ForageBrain, DoesNothingInTheFirstTickAndActsFromTheSecond) {
  Brain brain(config_for("homogeneous"), RobotId{1}, 1);
  const Command first = brain.decide(percept(0, {enemy(9, 0)}));
  EXPECT_EQ(first.velocity_mps, BodyVec());
  EXPECT_EQ(reported(brain).state, "Patrol");
  static_cast<void>(brain.decide(percept(1, {enemy(9, 0)})));  // Enters Intercept.
  const Command third = brain.decide(percept(2, {enemy(9, 0)}));
  EXPECT_EQ(third.act, Act::Intercept);
  EXPECT_NEAR(third.velocity_mps.x(), 0.4, 1e-12);
}

TEST(ForageBrain, DoesNothingInTheTickInWhichTheRoleChanges) {
  Brain brain(config_for("homogeneous"), RobotId{1}, 1);
  for (Tick tick = 0; tick < 3; ++tick) {
    static_cast<void>(brain.decide(percept(tick, {mine(9, 0)})));
  }
  EXPECT_GT(brain.decide(percept(3, {mine(9, 0)})).velocity_mps.x(), 0.0);
  const Command changing = brain.decide(percept(4, {mine(9, 0), enemy(20, 0)}));
  EXPECT_EQ(changing.velocity_mps, BodyVec());
  EXPECT_EQ(changing.act, Act::None);
  EXPECT_EQ(reported(brain).role, "Soldier");
}

TEST(ForageBrain, BeginsARoleThatItComesBackToInItsFirstState) {
  Brain brain(config_for("homogeneous"), RobotId{1}, 1);
  for (Tick tick = 0; tick < 3; ++tick) {
    static_cast<void>(brain.decide(percept(tick, {mine(9, 0)})));
  }
  EXPECT_EQ(reported(brain).state, "MoveToMine");
  static_cast<void>(brain.decide(percept(3, {mine(9, 0), enemy(20, 0)})));
  static_cast<void>(brain.decide(percept(4, {mine(9, 0)})));
  EXPECT_EQ(reported(brain).state, "LookForMine");
}

TEST(ForageBrain, TakesAMineToTheBase) {
  Brain brain(config_for("heterogeneous"), RobotId{1}, 1);
  const auto live = [&brain](Tick tick, std::vector<Sighting> sightings, bool holding) {
    Percept now = percept(tick, std::move(sightings));
    now.holding = holding;
    return brain.decide(now).act;
  };
  std::vector<Act> acts;
  acts.push_back(live(0, {mine(0.4, 0), base(0.5, 0)}, false));  // LookForMine
  acts.push_back(live(1, {mine(0.4, 0), base(0.5, 0)}, false));  // MoveToMine
  acts.push_back(live(2, {mine(0.4, 0), base(0.5, 0)}, false));  // PickUp
  acts.push_back(live(3, {mine(0.4, 0), base(0.5, 0)}, false));
  acts.push_back(live(4, {base(0.5, 0)}, true));  // MoveToBase
  acts.push_back(live(5, {base(0.5, 0)}, true));  // Drop
  acts.push_back(live(6, {base(0.5, 0)}, true));
  EXPECT_EQ(acts, (std::vector{Act::None, Act::None, Act::None, Act::PickUp, Act::None, Act::None,
                               Act::Drop}));
}

TEST(ForageBrain, DoesNothingAndLearnsNothingWhileDisabled) {
  Brain brain(config_for("q"), RobotId{1}, 1);
  for (Tick tick = 0; tick < 3; ++tick) {
    static_cast<void>(brain.decide(percept(tick, {mine(9, 0)})));
  }
  const std::string policy = brain.policy();
  for (Tick tick = 3; tick < 50; ++tick) {
    Percept now = percept(tick, {enemy(1, 0), disabled(1, 0)});
    now.able = false;
    now.deeds.stored = true;
    const Command command = brain.decide(now);
    EXPECT_EQ(command.tick, tick);
    EXPECT_EQ(command.velocity_mps, BodyVec());
    EXPECT_EQ(command.turn_radps, 0.0);
    EXPECT_EQ(command.act, Act::None);
  }
  EXPECT_EQ(brain.policy(), policy);
  EXPECT_EQ(reported(brain).role, "");
  EXPECT_TRUE(reported(brain).shares.empty());
}

TEST(ForageBrain, QueriesOnceOnRevivalAndBeginsItsRoleAnew) {
  Brain brain(config_for("q"), RobotId{1}, 1);
  Percept now = percept(0, {mine(9, 0), enemy(9, 0), disabled(9, 0)});
  for (Tick tick = 0; tick < 3; ++tick) {
    now.tick = tick;
    static_cast<void>(brain.decide(now));
  }
  EXPECT_EQ(brain.lessons(), 0U);
  now.tick = 3;
  now.able = false;
  static_cast<void>(brain.decide(now));
  now.tick = 4;
  now.able = true;
  EXPECT_EQ(brain.decide(now).velocity_mps, BodyVec());
  EXPECT_EQ(brain.lessons(), 1U);
  const std::string state = reported(brain).state;
  EXPECT_TRUE(state == "LookForMine" || state == "Patrol" || state == "Search") << state;
}

TEST(ForageBrain, BeginsEvenTheSameRoleAnewOnRevival) {
  Brain brain(config_for("heterogeneous"), RobotId{1}, 1);
  Percept now = percept(0, {mine(9, 0)});
  for (; now.tick < 4; ++now.tick) static_cast<void>(brain.decide(now));
  EXPECT_EQ(reported(brain).state, "MoveToMine");
  now.able = false;
  static_cast<void>(brain.decide(now));
  ++now.tick;
  now.able = true;
  EXPECT_EQ(brain.decide(now).velocity_mps, BodyVec());
  EXPECT_EQ(reported(brain).state, "LookForMine");
}

TEST(ForageBrain, ReportsItsRoleStateTriggersAndShares) {
  Brain brain(config_for("homogeneous"), RobotId{7}, 1);
  for (Tick tick = 0; tick < 3; ++tick) {
    static_cast<void>(brain.decide(percept(tick, {disabled(4, 0), mine(1, 0)})));
  }
  Telemetry telemetry;
  telemetry.decisions = 77;
  brain.report(telemetry);
  EXPECT_EQ(telemetry.robot, RobotId{7});
  EXPECT_EQ(telemetry.tick, 2U);
  EXPECT_EQ(telemetry.learner, "homogeneous");
  EXPECT_EQ(telemetry.role, "Mechanic");
  EXPECT_EQ(telemetry.state, "MoveToDisabled");
  EXPECT_EQ(telemetry.situation, "DetectDead+IsDieOff");
  ASSERT_EQ(telemetry.shares.size(), 4U);
  EXPECT_EQ(telemetry.shares[0].name, "MoveToDisabled");
  EXPECT_EQ(telemetry.shares[0].push, BodyVec(1, 0));
  EXPECT_EQ(telemetry.decisions, 77U);
}

TEST(ForageBrain, ReportsNoSituationWhenNoTriggerIsTrue) {
  Brain brain(config_for("q"), RobotId{7}, 1);
  static_cast<void>(brain.decide(percept(0, {mine(1, 0)})));
  EXPECT_EQ(reported(brain).situation, "");
}

TEST(ForageBrain, LearnsThatForagingPaysWhenItDoes) {
  // Alone in a world where ten ticks of foraging bring a mine home, and nothing else brings a
  // thing.
  BrainConfig config = config_for("q");
  Brain learning(config, RobotId{1}, 3);
  Tick foraging = 0;
  for (Tick tick = 0; tick < 20000; ++tick) {
    Percept now = percept(tick, {mine(9, 0)});
    foraging = reported(learning).role == "Forager" ? foraging + 1 : 0;
    now.deeds.stored = foraging > 0 && foraging % 10 == 0;
    static_cast<void>(learning.decide(now));
  }
  config.q.learner.learning = false;
  Brain learned(config, RobotId{1}, 4);
  learned.inherit(learning.policy(), "learned");
  for (Tick tick = 0; tick < 200; ++tick) {
    static_cast<void>(learned.decide(percept(tick, {mine(9, 0)})));
    EXPECT_EQ(reported(learned).role, "Forager") << tick;
  }
}

}  // namespace
}  // namespace tacit
