#include <gtest/gtest.h>

#include "tests/world/operation_field.h"

namespace tacit {
namespace {

Control told(ControlKind kind, std::uint16_t robot, const WorldVec& joystick = {}) {
  return {kind, 1, 0.0, RobotId{robot}, joystick};
}

WorldConfig asking(const Starts& starts) {
  WorldConfig config = on_floor(starts);
  config.operation.proceed = "ask";
  return config;
}

TEST(Operator, SteersInTheRobotsFrameUntilTheStickIsLetGo) {
  Field field(on_floor({{2.0, 5.0, 90.0}}));
  EXPECT_TRUE(field.world.operate(told(ControlKind::Steer, 1, {0.5, 0.0})));
  EXPECT_FALSE(field.percept(1).operated.teleoperated);
  for (int i = 0; i < 3; ++i) {
    field.step();
    EXPECT_TRUE(field.percept(1).operated.teleoperated);
    EXPECT_NEAR(field.percept(1).operated.joystick.x(), 0.0, 1e-12);
    EXPECT_NEAR(field.percept(1).operated.joystick.y(), -0.5, 1e-12);
  }
  EXPECT_TRUE(field.world.operate(told(ControlKind::LetGo, 1)));
  field.step();
  EXPECT_FALSE(field.percept(1).operated.teleoperated);
  EXPECT_EQ(field.percept(1).operated.joystick, BodyVec());
}

TEST(Operator, TurnsTheStickWithTheRobot) {
  Field field(on_floor({{2.0, 5.0, 0.0}}));
  field.world.operate(told(ControlKind::Steer, 1, {1.0, 0.0}));
  Command turning = acting(1, Act::None);
  turning.turn_radps = 1.0;
  repeat(field, 5, {turning});
  EXPECT_NEAR(field.percept(1).operated.joystick.x(), sin_cos(0.5).cos, 1e-9);
  EXPECT_NEAR(field.percept(1).operated.joystick.y(), -sin_cos(0.5).sin, 1e-9);
}

TEST(Operator, LeavesATraceOfEachChange) {
  Field field(on_floor({{2.0, 5.0, 0.0}}));
  const WorldVec east{1.0, 0.0};
  field.world.operate(told(ControlKind::Steer, 1, {0.0, 1.0}));
  field.world.operate(told(ControlKind::Steer, 1, east));
  field.step();
  EXPECT_EQ(field.all<OperatorActed>(),
            (std::vector<OperatorActed>{{RobotId{1}, OperatorAct::Steer, east}}));
  field.world.operate(told(ControlKind::Steer, 1, east));
  field.step();
  EXPECT_TRUE(field.all<OperatorActed>().empty());
  field.world.operate(told(ControlKind::LetGo, 1));
  field.step();
  EXPECT_EQ(field.all<OperatorActed>(),
            (std::vector<OperatorActed>{{RobotId{1}, OperatorAct::LetGo, {}}}));
}

TEST(Operator, GivesTheWordToGoOnForOneTick) {
  Field field(asking({{2.0, 5.0, 0.0}, {4.0, 5.0, 0.0}}));
  field.world.operate(told(ControlKind::Proceed, 2));
  field.step();
  EXPECT_FALSE(field.percept(1).operated.proceed);
  EXPECT_TRUE(field.percept(2).operated.proceed);
  EXPECT_EQ(field.all<OperatorActed>(),
            (std::vector<OperatorActed>{{RobotId{2}, OperatorAct::Proceed, {}}}));
  field.step();
  EXPECT_FALSE(field.percept(2).operated.proceed);
  EXPECT_TRUE(field.all<OperatorActed>().empty());
}

TEST(Operator, LetsAGoalBeSkippedForOneTick) {
  Field field(on_floor({{2.0, 5.0, 0.0}}));
  field.world.operate(told(ControlKind::SkipGoal, 1));
  field.step();
  EXPECT_TRUE(field.percept(1).operated.skip_goal);
  EXPECT_EQ(field.all<OperatorActed>(),
            (std::vector<OperatorActed>{{RobotId{1}, OperatorAct::SkipGoal, {}}}));
  field.step();
  EXPECT_FALSE(field.percept(1).operated.skip_goal);
}

TEST(Operator, WhoIsNotThereLetsRobotsGoOnAtOnce) {
  Field field(on_floor({{2.0, 5.0, 0.0}}));
  EXPECT_TRUE(field.percept(1).operated.proceed);
  field.step();
  EXPECT_TRUE(field.percept(1).operated.proceed);
  EXPECT_TRUE(field.all<OperatorActed>().empty());
}

TEST(Operator, SpeaksToTheWholeTeamButNotToExtras) {
  WorldConfig config = asking({{2.0, 5.0, 0.0}, {4.0, 5.0, 0.0}, {8.0, 5.0, 0.0}});
  Field field(with_extras(config, 1));
  field.world.operate(told(ControlKind::Proceed, 0));
  field.step();
  EXPECT_TRUE(field.percept(1).operated.proceed);
  EXPECT_TRUE(field.percept(2).operated.proceed);
  EXPECT_FALSE(field.percept(3).operated.proceed);
}

TEST(Operator, IsRefusedWhatIsNoWordOfAnOperatorOrForNobody) {
  Field field(on_floor({{2.0, 5.0, 0.0}}));
  EXPECT_FALSE(field.world.operate(told(ControlKind::Pause, 1)));
  EXPECT_FALSE(field.world.operate(told(ControlKind::Proceed, 2)));
  field.step();
  EXPECT_TRUE(field.all<OperatorActed>().empty());
}

TEST(Operator, HasNothingToSayInAnotherMission) {
  World world(bare_field(1), 1);
  EXPECT_FALSE(world.operate(told(ControlKind::Steer, 1, {1.0, 0.0})));
}

}  // namespace
}  // namespace tacit
