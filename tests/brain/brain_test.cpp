#include "robot_agent/brain/brain.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/brain/percepts.h"

namespace tacit {
namespace {

using testing::busy_percept;
using testing::percept;

BrainConfig config_for(const char* learner) {
  BrainConfig config;
  config.learner = learner;
  config.lm.period_ticks = 3;
  // Slow enough that nothing is clipped, since clipping would hide differences.
  config.actuator.base_mps = 0.01;
  return config;
}

/// What a brain answers to `make(0)`, `make(1)`, …
template <class Make>
std::vector<Command> answers(const BrainConfig& config, Make make) {
  Brain brain(config, RobotId{1}, 99);
  std::vector<Command> commands;
  for (Tick tick = 0; tick < 60; ++tick) commands.push_back(brain.decide(make(tick)));
  return commands;
}

class Laws : public ::testing::TestWithParam<const char*> {};

TEST_P(Laws, EqualSeedsAndPerceptsGiveEqualDecisions) {
  const auto make = [](Tick tick) { return busy_percept(tick, 1); };
  const auto once = answers(config_for(GetParam()), make);
  const auto again = answers(config_for(GetParam()), make);

  for (std::size_t i = 0; i < once.size(); ++i) {
    EXPECT_EQ(once[i].velocity_mps, again[i].velocity_mps);
    EXPECT_EQ(once[i].turn_radps, again[i].turn_radps);
  }
}

TEST_P(Laws, TheOrderOfSightingsChangesNothingButRounding) {
  const auto straight =
      answers(config_for(GetParam()), [](Tick tick) { return busy_percept(tick, 1); });
  const auto shuffled = answers(config_for(GetParam()), [](Tick tick) {
    Percept percept = busy_percept(tick, 1);
    Stream chance(8, "shuffle", tick);
    for (std::size_t i = percept.sightings.size(); i > 1; --i) {
      std::swap(percept.sightings[i - 1], percept.sightings[chance.below(i)]);
    }
    std::reverse(percept.obstacles.begin(), percept.obstacles.end());
    return percept;
  });

  for (std::size_t i = 0; i < straight.size(); ++i) {
    EXPECT_NEAR(straight[i].velocity_mps.x(), shuffled[i].velocity_mps.x(), 1e-12);
    EXPECT_NEAR(straight[i].velocity_mps.y(), shuffled[i].velocity_mps.y(), 1e-12);
  }
}

TEST_P(Laws, ARobotThatFacesElsewhereWantsTheSameMotionOverGround) {
  const auto straight =
      answers(config_for(GetParam()), [](Tick tick) { return busy_percept(tick, 1); });
  const double angle_rad = 0.7;
  const Heading turn = Heading::from_rad(angle_rad);
  const auto turned = answers(config_for(GetParam()), [&](Tick tick) {
    Percept percept = busy_percept(tick, 1);
    const auto seen_turned = [&](const BodyVec& v) { return to_body(turn, OdometryVec(v.xy)); };
    percept.odometry.heading = percept.odometry.heading.turned(angle_rad);
    for (Sighting& each : percept.sightings) each.offset_m = seen_turned(each.offset_m);
    for (SeenObstacle& each : percept.obstacles) each.offset_m = seen_turned(each.offset_m);
    return percept;
  });

  for (std::size_t i = 0; i < straight.size(); ++i) {
    const BodyVec wanted = to_body(turn, OdometryVec(straight[i].velocity_mps.xy));
    EXPECT_NEAR(turned[i].velocity_mps.x(), wanted.x(), 1e-12);
    EXPECT_NEAR(turned[i].velocity_mps.y(), wanted.y(), 1e-12);
  }
}

TEST_P(Laws, AMirroredSceneGivesTheMirroredDecision) {
  BrainConfig config = config_for(GetParam());
  config.crowd.of<Noise>() = 0.0;
  const auto straight = answers(config, [](Tick tick) { return busy_percept(tick, 1); });
  const auto mirrored = answers(config, [](Tick tick) {
    Percept percept = busy_percept(tick, 1);
    const auto mirror = [](const auto& v) { return std::decay_t<decltype(v)>(v.x(), -v.y()); };
    percept.odometry.position_m = mirror(percept.odometry.position_m);
    percept.odometry.heading.sin = -percept.odometry.heading.sin;
    for (Sighting& each : percept.sightings) each.offset_m = mirror(each.offset_m);
    for (SeenObstacle& each : percept.obstacles) each.offset_m = mirror(each.offset_m);
    return percept;
  });

  for (std::size_t i = 0; i < straight.size(); ++i) {
    EXPECT_NEAR(mirrored[i].velocity_mps.x(), straight[i].velocity_mps.x(), 1e-12);
    EXPECT_NEAR(mirrored[i].velocity_mps.y(), -straight[i].velocity_mps.y(), 1e-12);
    EXPECT_NEAR(mirrored[i].turn_radps, -straight[i].turn_radps, 1e-9);
  }
}

TEST_P(Laws, MovingTheOriginOfOdometryChangesNothingButRounding) {
  const auto straight =
      answers(config_for(GetParam()), [](Tick tick) { return busy_percept(tick, 1); });
  const auto moved = answers(config_for(GetParam()), [](Tick tick) {
    Percept percept = busy_percept(tick, 1);
    percept.odometry.position_m += OdometryVec{123.0, -45.0};
    return percept;
  });

  for (std::size_t i = 0; i < straight.size(); ++i) {
    EXPECT_NEAR(straight[i].velocity_mps.x(), moved[i].velocity_mps.x(), 1e-12);
    EXPECT_NEAR(straight[i].velocity_mps.y(), moved[i].velocity_mps.y(), 1e-12);
  }
}

INSTANTIATE_TEST_SUITE_P(Learners, Laws, ::testing::Values("static1", "static2", "lm", "crowd"),
                         [](const auto& learner) { return std::string(learner.param); });

TEST(Brain, AnswersForItsRobotAndThePerceptsTick) {
  Brain brain({}, RobotId{4}, 1);
  const Command command = brain.decide(percept(17, {}));
  EXPECT_EQ(command.robot, RobotId{4});
  EXPECT_EQ(command.tick, 17U);
}

TEST(Brain, StandsStillWhenNothingIsSensed) {
  Brain brain({}, RobotId{4}, 1);
  const Command command = brain.decide(percept(17, {}));
  EXPECT_EQ(command.velocity_mps, BodyVec());
  EXPECT_EQ(command.turn_radps, 0.0);
}

TEST(Brain, NeverWantsMoreThanTheTopSpeed) {
  const BrainConfig config;
  Brain brain(config, RobotId{4}, 1);
  for (Tick tick = 0; tick < 200; ++tick) {
    const Command command = brain.decide(busy_percept(tick, 5));
    EXPECT_LE(command.velocity_mps.norm(), config.actuator.max_mps * (1.0 + 1e-12));
  }
}

TEST(Brain, MovesByTheWeightedSumThatItReports) {
  BrainConfig config = config_for("lm");
  Brain brain(config, RobotId{4}, 1);
  for (Tick tick = 0; tick < 50; ++tick) {
    const Command command = brain.decide(busy_percept(tick, 5));
    Telemetry telemetry;
    brain.report(telemetry);
    BodyVec sum;
    for (const SchemaShare& share : telemetry.shares) sum += share.gain * share.push;
    EXPECT_NEAR(command.velocity_mps.x(), config.actuator.base_mps * sum.x(), 1e-12);
    EXPECT_NEAR(command.velocity_mps.y(), config.actuator.base_mps * sum.y(), 1e-12);
  }
}

TEST(Brain, ReportsWhoWhenHowAndInWhichSituation) {
  Brain brain({}, RobotId{4}, 1);
  static_cast<void>(brain.decide(percept(10, {testing::enemy(5, 5)})));
  Telemetry telemetry;
  telemetry.decisions = 77;
  brain.report(telemetry);
  EXPECT_EQ(telemetry.robot, RobotId{4});
  EXPECT_EQ(telemetry.tick, 10U);
  EXPECT_EQ(telemetry.learner, "lm");
  EXPECT_EQ(telemetry.situation, "FlankingEnemy");
  ASSERT_EQ(telemetry.shares.size(), 4U);
  EXPECT_EQ(telemetry.shares[0].name, "MoveToTarget");
  EXPECT_EQ(telemetry.decisions, 77U);
}

TEST(Brain, KeepsASchemaThatIsSilentButCanBeRaised) {
  BrainConfig config = config_for("lm");
  config.lm.initial.of<InterceptEnemies>() = 0.0;
  config.lm.min.intercept = 0.0;
  Brain brain(config, RobotId{1}, 3);
  const Percept first = percept(2, {testing::enemy(20, 0)});
  const Percept adapting = percept(3, {testing::enemy(20, 0)});

  EXPECT_EQ(brain.decide(first).velocity_mps, BodyVec());
  EXPECT_GT(brain.decide(adapting).velocity_mps.x(), 0.0);
}

TEST(Brain, OfACrowdPaysNoHeedToEnemies) {
  BrainConfig config;
  config.learner = "crowd";
  Brain blind(config, RobotId{1}, 3);
  Brain seeing(config, RobotId{1}, 3);
  const Percept without = percept(0, {testing::target(10, 0)});
  const Percept with = percept(0, {testing::target(10, 0), testing::enemy(5, 5)});
  EXPECT_EQ(blind.decide(without).velocity_mps, seeing.decide(with).velocity_mps);
}

TEST(Brain, CarriesOnFromItsMemory) {
  const BrainConfig config = config_for("lm");
  Brain first(config, RobotId{1}, 3);
  for (Tick tick = 0; tick < 31; ++tick) static_cast<void>(first.decide(busy_percept(tick, 2)));
  Brain second(config, RobotId{1}, 3);

  ASSERT_TRUE(second.recall(first.memory()));

  EXPECT_EQ(second.memory(), first.memory());
}

TEST(Brain, OfAGuardRemembersItsPolicyAlone) {
  Brain brain(config_for("lm"), RobotId{1}, 3);
  for (Tick tick = 0; tick < 31; ++tick) static_cast<void>(brain.decide(busy_percept(tick, 2)));
  EXPECT_EQ(brain.memory(), brain.policy());
  EXPECT_EQ(brain.memory("a policy"), "a policy");
}

TEST(Brain, RefusesTheMemoryOfAnotherLearner) {
  Brain learning(config_for("lm"), RobotId{1}, 3);
  Brain fixed(config_for("static1"), RobotId{1}, 3);
  EXPECT_FALSE(fixed.recall(learning.memory()));
  EXPECT_FALSE(learning.recall(fixed.memory()));
  EXPECT_TRUE(fixed.recall(fixed.memory()));
}

}  // namespace
}  // namespace tacit
