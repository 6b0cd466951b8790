#include <gtest/gtest.h>

#include "idl/types/config_error.h"
#include "robot_agent/brain/mission/compile.h"
#include "tests/brain/mission_robot.h"

namespace tacit {
namespace {

using testing::last;
using testing::mission_of;
using testing::MissionRobot;
using testing::rule;
using testing::state;

std::string refusal(const std::string& text) {
  try {
    static_cast<void>(compile_mission(text, "m.cdl"));
  } catch (const ConfigError& error) {
    return error.what();
  }
  return "none";
}

std::string one_state(const std::string& behaviour) {
  return mission_of(last(state("Start", behaviour) + rule("Start", "Never", "Start")));
}

TEST(Mission, BeginsInStartWhereverItStands) {
  MissionRobot robot(
      mission_of(last(state("B", "Stop") + state("Start", "Stop") + rule("Start", "Never", "B"))));
  static_cast<void>(robot.see());
  EXPECT_EQ(robot.state(), "Start");
}

TEST(Mission, MakesOneTransitionATickAndDoesNothingInIt) {
  MissionRobot robot(
      mission_of(last(state("Start", "Stop") + state("A", "%Goal_Location = {9, 0}, GoTo") +
                      state("B", "%Goal_Location = {9, 0}, GoTo") +
                      rule("Start", "Immediate", "A") + rule("A", "%Delay = {0.2}, Wait", "B"))));
  std::vector<std::string> states;
  std::vector<double> speeds;
  for (int tick = 0; tick < 5; ++tick) {
    speeds.push_back(robot.see().velocity_mps.x());
    states.push_back(robot.state());
  }
  EXPECT_EQ(states, (std::vector<std::string>{"Start", "A", "A", "B", "B"}));
  EXPECT_EQ(speeds, (std::vector<double>{0.0, 0.0, 1.0, 0.0, 1.0}));
}

TEST(Mission, TakesTheFirstRuleThatFires) {
  MissionRobot robot(
      mission_of(last(state("Start", "Stop") + state("A", "Stop") + state("B", "Stop") +
                      rule("Start", "Never", "A") + rule("Start", "Immediate", "B") +
                      rule("Start", "Immediate", "A"))));
  static_cast<void>(robot.see());
  static_cast<void>(robot.see());
  EXPECT_EQ(robot.state(), "B");
}

TEST(Mission, AutomataNest) {
  const std::string inner = "FSA(" +
                            last(state("Start", "Stop") +
                                 state("Done",
                                       "%notify_message = "
                                       "{\"inner done\"}, "
                                       "ExitTask") +
                                 rule("Start", "%Delay = {0.3}, Wait", "Done")) +
                            ")";
  MissionRobot robot(
      mission_of(last(state("Start", inner) + state("After", "Stop") +
                      rule("Start", "%notify_message = {\"inner done\"}, TaskExited", "After"))));
  static_cast<void>(robot.see());
  EXPECT_EQ(robot.state(), "Start/Start");
  for (int tick = 1; tick <= 3; ++tick) static_cast<void>(robot.see());
  EXPECT_EQ(robot.state(), "Start/Done");
  static_cast<void>(robot.see());
  EXPECT_EQ(robot.state(), "After");
}

TEST(Mission, WheelsSetTheSpeeds) {
  Percept beside_a_wall;
  beside_a_wall.obstacles = {{{0.0, 0.2}, 0.0}};
  const std::string go = one_state("%Goal_Location = {9, 0}, GoTo");
  std::string cautious = go;
  cautious.replace(cautious.find("cautious_mode = {false}"), 23, "cautious_mode = {true}");
  MissionRobot bold(go);
  MissionRobot careful(cautious);
  static_cast<void>(bold.see());
  static_cast<void>(careful.see());
  EXPECT_DOUBLE_EQ(bold.see().velocity_mps.x(), 1.0);
  EXPECT_DOUBLE_EQ(careful.see().velocity_mps.x(), 1.0);
  EXPECT_DOUBLE_EQ(bold.see(beside_a_wall).velocity_mps.norm(), 2.0);
  EXPECT_DOUBLE_EQ(careful.see(beside_a_wall).velocity_mps.norm(), 0.1);
}

TEST(Mission, WeightedSumsAreMadeOfPrimitives) {
  MissionRobot robot(one_state(
      "COOP(members[A]<1,1> = MOVE_TO(%classes = {Flags}), members[B]<1,1> = "
      "AVOID_OBSTACLES(sphere = {2.0}, safety_margin = {1.0}), weight[A] = {0.5}, weight[B] = "
      "{1.0}, %act = {PickUp})"));
  static_cast<void>(robot.see());
  Percept percept;
  percept.sightings = {{Kind::Object, Colour::Purple, {4.0, 0.0}, 0.2}};
  percept.obstacles = {{{0.0, 1.5}, 0.0}};
  const Command command = robot.see(percept);
  EXPECT_DOUBLE_EQ(command.velocity_mps.x(), 0.5);
  EXPECT_DOUBLE_EQ(command.velocity_mps.y(), -0.5);
  EXPECT_EQ(command.act, Act::PickUp);
}

std::string learner() {
  std::string text = one_state("Stop");
  const std::size_t begin = text.find("FSA(");
  const std::size_t end = text.find("),\nmax_vel");
  return text.replace(begin, end - begin,
                      "QLEARN(triggers[T]<1,1> = [%Objects = {Flags}, Detect], society[A]<1,1> = "
                      "[Stop], society[B]<1,1> = [%Objects = {Flags}, MoveToward], reinforcers[R] "
                      "= {3,1,10}, reinforcers[S] = {-1000,0,1}, ActionTimeout = {5}, alpha = "
                      "{0.5}, random = {0.5}");
}

TEST(Mission, LearnersRememberAcrossACrash) {
  Percept flag;
  flag.sightings = {{Kind::Object, Colour::Purple, {4.0, 0.0}, 0.2}};
  MissionRobot whole(learner());
  MissionRobot crashed(learner());
  const auto scene = [&flag](int tick) { return tick / 7 % 2 == 0 ? flag : Percept{}; };
  for (int tick = 0; tick < 100; ++tick) {
    static_cast<void>(whole.see(scene(tick)));
    static_cast<void>(crashed.see(scene(tick)));
  }
  EXPECT_GT(whole.brain().lessons(), 10U);
  MissionRobot restarted(learner());
  ASSERT_TRUE(restarted.brain().recall(crashed.brain().memory()));
  EXPECT_EQ(restarted.brain().memory(), whole.brain().memory());
  restarted.skip_to(100);
  for (int tick = 100; tick < 200; ++tick) {
    ASSERT_EQ(restarted.see(scene(tick)).velocity_mps, whole.see(scene(tick)).velocity_mps) << tick;
  }
}

TEST(Mission, AnotherRunBeginsWithWhatWasLearned) {
  MissionRobot first(learner());
  for (int tick = 0; tick < 50; ++tick) static_cast<void>(first.see());
  MissionRobot second(learner());
  second.brain().inherit(first.brain().policy(), "p");
  EXPECT_EQ(second.brain().lessons(), first.brain().lessons());
  EXPECT_THROW(second.brain().inherit("nonsense", "p"), ConfigError);
}

TEST(Mission, MomentumGrowsTheGoalsGainWithProgress) {
  MissionRobot robot(one_state("%Goal_Location = {100, 0}, GoTo_LM"));
  double first = 0.0;
  double then = 0.0;
  for (int tick = 0; tick < 60; ++tick) {
    Percept percept;
    percept.odometry.position_m = {0.1 * tick, 0.0};
    const double speed = robot.see(percept).velocity_mps.x();
    if (tick == 2) first = speed;
    then = speed;
  }
  EXPECT_DOUBLE_EQ(first, 1.0);
  EXPECT_GT(then, 1.5);  // The gain is at 2.0 by then, the noise next to nothing.
}

TEST(Mission, SaysWhereSomethingIsNotKnown) {
  const std::string text = one_state("Levitate");
  EXPECT_NE(refusal(text).find("m.cdl:3:1: error: behaviour Levitate is not one that Tacit runs"),
            std::string::npos)
      << refusal(text);
  EXPECT_NE(refusal(one_state("GoToo")).find("did you mean \"GoTo\"?"), std::string::npos);
  EXPECT_NE(refusal(mission_of(last(state("Start", "Stop") + rule("Start", "Nearr", "Start"))))
                .find("trigger Nearr is not one"),
            std::string::npos);
}

TEST(Mission, RefusesParametersThatCannotBe) {
  EXPECT_NE(refusal(one_state("GoTo")).find("lacks the parameter %Goal_Location"),
            std::string::npos);
  EXPECT_NE(refusal(one_state("%Goal_Location = {here}, GoTo")).find("wanted a point"),
            std::string::npos);
  EXPECT_NE(refusal(one_state("%Objects = {Unicorns}, MoveToward"))
                .find("no things are called \"Unicorns\""),
            std::string::npos);
  EXPECT_NE(refusal(one_state("%proceed_direction = {Up}, ProceedAlongHallway"))
                .find("wanted Facing, Left or Right"),
            std::string::npos);
  EXPECT_NE(refusal(one_state("%notify_message = {\"" + std::string(64, 'x') + "\"}, NotifyRobots"))
                .find("wanted at most 63"),
            std::string::npos);
}

TEST(Mission, TellsEveryFaultOnce) {
  const std::string text = refusal(mission_of(
      last(state("Start", "Fly") + state("A", "Swim") + rule("Start", "Immediate", "A"))));
  EXPECT_NE(text.find("Fly"), std::string::npos);
  EXPECT_NE(text.find("Swim"), std::string::npos);
}

TEST(Mission, StatesThatNobodyReachesDoNotMatter) {
  EXPECT_EQ(refusal(mission_of(last(state("Start", "Stop") + state("Idle", "Levitate") +
                                    rule("Start", "Never", "Start")))),
            "none");
}

TEST(Mission, RefusesTextsThatAreNone) {
  EXPECT_NE(refusal("what is this"), "none");
  EXPECT_NE(refusal(""), "none");
  EXPECT_NE(refusal("bindArch AuRA;\n"), "none");
}

TEST(Mission, EachRobotHasItsPart) {
  BrainConfig config = MissionRobot::config(one_state("Stop"), {0.0, 0.0, 0.0});
  EXPECT_NO_THROW(Brain(config, RobotId{1}, 1));
  EXPECT_THROW(Brain(config, RobotId{2}, 1), ConfigError);
  config.script.extras = one_state("Stop");
  config.script.starts.push_back({1.0, 1.0, 0.0});
  EXPECT_NO_THROW(Brain(config, RobotId{2}, 1));
  EXPECT_THROW(Brain(config, RobotId{3}, 1), ConfigError);
}

TEST(Mission, ForeignMemoriesAreRefused) {
  MissionRobot robot(one_state("Stop"));
  for (const char* text :
       {"", "x",
        "tacit-operation-memory 1\nbegun 1\nhome\ncourse\nentrance\ninwards\nproceeded\nrecord\n",
        "tacit-operation-memory 1\nbegun 1\nhome\ncourse\nentrance\ninwards\nproceeded\nrecord 99 "
        "0 0 0 1 0\n",
        "tacit-operation-memory 1\nbegun 2\nhome\ncourse\nentrance\ninwards\nproceeded\nrecord\n",
        "tacit-operation-memory 1\nbegun 1\nhome\ncourse\nentrance\ninwards\nproceeded\nrecord 0 0 "
        "0 0 nan 0\n"}) {
    EXPECT_FALSE(robot.brain().recall(text)) << text;
  }
}

}  // namespace
}  // namespace tacit
