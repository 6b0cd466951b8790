#include <gtest/gtest.h>

#include "robot_agent/brain/mission/triggers.h"
#include "tests/brain/mission_robot.h"

namespace tacit {
namespace {

using testing::last;
using testing::mission_of;
using testing::MissionRobot;
using testing::rule;
using testing::state;

/// Whether a robot that sees `percept`, a tick after it has seen nothing, leaves its state by
/// `trigger`.
bool fires(const std::string& trigger, const Percept& percept) {
  MissionRobot robot(mission_of(
      last(state("Start", "Stop") + state("Next", "Stop") + rule("Start", trigger, "Next"))));
  static_cast<void>(robot.see());
  static_cast<void>(robot.see(percept));
  return robot.state() == "Next";
}

Percept with(std::vector<Sighting> sightings) {
  Percept percept;
  percept.sightings = std::move(sightings);
  return percept;
}

Percept at(double x, double y, double heading_deg = 0.0) {
  Percept percept;
  percept.odometry = {{x, y}, Heading::from_rad(heading_deg * kPi / 180.0)};
  return percept;
}

Percept deed(bool Deeds::*what) {
  Percept percept;
  percept.deeds.*what = true;
  return percept;
}

Percept in_hallway(double ahead_m, double behind_m) {
  Percept percept;
  percept.site = Site::Hallway;
  percept.hallway = SeenHallway{{}, {1.0, 0.0}, ahead_m, behind_m, 2.0};
  return percept;
}

TEST(MissionTriggers, ImmediateAndNever) {
  EXPECT_TRUE(fires("Immediate", {}));
  EXPECT_FALSE(fires("Never", {}));
}

TEST(MissionTriggers, GoalsCountOnTheMap) {
  const std::string goal = "%Goal_Location = {10, 0}, %Goal_Tolerance = {0.5}, ";
  EXPECT_TRUE(fires(goal + "AtGoal", at(9.6, 0.0)));
  EXPECT_FALSE(fires(goal + "AtGoal", at(9.4, 0.0)));
  EXPECT_TRUE(fires(goal + "SubMissionReady", at(9.6, 0.0)));
  Percept skip = at(0.0, 0.0);
  EXPECT_FALSE(fires(goal + "AtOrSkipGoal", skip));
  skip.operated.skip_goal = true;
  EXPECT_TRUE(fires(goal + "AtOrSkipGoal", skip));
  EXPECT_FALSE(fires(goal + "AtGoal", skip));
}

TEST(MissionTriggers, FormationsArriveWithTheirCentre) {
  const std::string goal = "%Goal_Location = {10, 0}, %Goal_Tolerance = {0.5}, AtGoalInFormation";
  Percept pair = at(9.0, 0.0);
  EXPECT_FALSE(fires(goal, pair));
  pair.sightings = {{Kind::Teammate, Colour::Blue, {2.0, 0.0}, 0.2}};
  EXPECT_TRUE(fires(goal, pair));
}

TEST(MissionTriggers, DetectsByColourAndRange) {
  const Percept flag = with({{Kind::Object, Colour::Purple, {20.0, 0.0}, 0.2}});
  EXPECT_TRUE(fires("%Objects = {Flags}, Detect", flag));
  EXPECT_FALSE(fires("%Objects = {Mines}, Detect", flag));
  EXPECT_FALSE(fires("%Objects = {Flags}, %max_sensor_range = {10}, Detect", flag));
  EXPECT_FALSE(fires("%Objects = {Flags}, NotDetected", flag));
  EXPECT_TRUE(fires("%Objects = {Mines}, NotDetected", flag));
  EXPECT_TRUE(fires("%Objects = {Mines}, UnDetect", flag));
}

TEST(MissionTriggers, RedRobotsAreEnemiesAndYellowOnesDisabled) {
  const Percept enemy = with({{Kind::Enemy, Colour::Red, {5.0, 0.0}, 0.2}});
  const Percept disabled = with({{Kind::Teammate, Colour::Yellow, {5.0, 0.0}, 0.2}});
  EXPECT_TRUE(fires("%Objects = {Enemies}, Detect", enemy));
  EXPECT_FALSE(fires("%Objects = {Friendly_Robots}, Detect", enemy));
  EXPECT_FALSE(fires("%Objects = {Friendly_Robots}, Detect", disabled));
  EXPECT_TRUE(fires("%Objects = {Disabled_Robots}, Detect", disabled));
  EXPECT_TRUE(fires("%Objects = {Robots}, Detect", enemy));
}

TEST(MissionTriggers, NearMeasuresToTheSurface) {
  const Percept home = with({{Kind::Object, Colour::White, {1.0, 0.0}, 0.75}});
  EXPECT_TRUE(fires("%Objects = {Start_Place}, %Distance = {0.3}, Near", home));
  EXPECT_FALSE(fires("%Objects = {Start_Place}, %Distance = {0.2}, Near", home));
  EXPECT_FALSE(
      fires("%Objects = {Start_Place}, %Distance = {0.3}, %measured_to = {Centre}, Near", home));
  EXPECT_TRUE(fires("%Objects = {Start_Place}, %Distance = {0.2}, AwayFrom", home));
}

TEST(MissionTriggers, HoldingTellsColours) {
  Percept held;
  held.holding = true;
  held.held = Colour::Orange;
  EXPECT_TRUE(fires("%Objects = {Mines}, Holding", held));
  EXPECT_FALSE(fires("%Objects = {Flags}, Holding", held));
  EXPECT_FALSE(fires("%Objects = {Mines}, NotHolding", held));
  EXPECT_TRUE(fires("NotHolding", {}));
}

TEST(MissionTriggers, RoomsAndHallwaysCountClearOfTheirDoorways) {
  Percept room;
  room.site = Site::Room;
  EXPECT_TRUE(fires("InRoom", room));
  EXPECT_FALSE(fires("InHallway", room));
  room.doorways = {{{0.0, 0.2}, {0.75, 0.0}, false}};
  EXPECT_FALSE(fires("InRoom", room));
  room.doorways = {{{2.0, 0.2}, {0.75, 0.0}, false}};  // Beside the opening, behind its wall.
  EXPECT_TRUE(fires("InRoom", room));
  Percept hallway = in_hallway(5, 5);
  EXPECT_TRUE(fires("InHallway", hallway));
  EXPECT_FALSE(fires("InRoom", hallway));
}

TEST(MissionTriggers, HallwaysEndWhereTheRobotGoes) {
  EXPECT_TRUE(fires("%Goal_Tolerance = {0.5}, AtEndOfHall", in_hallway(0.4, 10)));
  EXPECT_FALSE(fires("%Goal_Tolerance = {0.5}, AtEndOfHall", in_hallway(10, 0.4)));
  EXPECT_TRUE(fires("%Goal_Tolerance = {0.5}, NotAtEndOfHall", in_hallway(10, 0.4)));
  EXPECT_FALSE(fires("%Goal_Tolerance = {0.5}, AtEndOfHall", {}));
}

TEST(MissionTriggers, DoorwaysCountBesideTheRobotOnTheirSide) {
  Percept beside = in_hallway(5, 5);
  beside.doorways = {{{0.1, 1.0}, {0.75, 0.0}, false}};
  EXPECT_TRUE(fires("%direction = {Left}, AtDoorway", beside));
  EXPECT_FALSE(fires("%direction = {Right}, AtDoorway", beside));
  EXPECT_TRUE(fires("%direction = {Either}, AtDoorway", beside));
  beside.doorways[0].marked = true;
  EXPECT_FALSE(fires("%direction = {Left}, AtDoorway", beside));
  EXPECT_TRUE(fires("%direction = {Left}, %detect_which = {DETECT_ANY}, AtDoorway", beside));
  beside.doorways = {{{0.4, 1.0}, {0.75, 0.0}, false}};
  EXPECT_FALSE(fires("%direction = {Left}, AtDoorway", beside));
  beside.doorways = {{{0.0, 3.0}, {0.75, 0.0}, false}};
  EXPECT_FALSE(fires("%direction = {Left}, %Hallway_Width = {2.0}, AtDoorway", beside));
}

TEST(MissionTriggers, DeedsAreNoticed) {
  EXPECT_TRUE(fires("MarkedDoorway", deed(&Deeds::marked)));
  EXPECT_TRUE(fires("MessageSent", deed(&Deeds::signalled)));
  EXPECT_TRUE(fires("Alerted", deed(&Deeds::alerted)));
  for (const char* trigger : {"MarkedDoorway", "MessageSent", "Alerted", "TestPositive"}) {
    EXPECT_FALSE(fires(trigger, {})) << trigger;
  }
  Percept tested;
  tested.deeds.tested = Finding::Dangerous;
  EXPECT_TRUE(fires("TestPositive", tested));
  EXPECT_FALSE(fires("TestNegative", tested));
  tested.deeds.tested = Finding::Harmless;
  EXPECT_TRUE(fires("TestNegative", tested));
}

TEST(MissionTriggers, SignalsRingForASecond) {
  MissionRobot robot(
      mission_of(last(state("Start", "Stop") + state("Ready", "Stop") + state("Next", "Stop") +
                      rule("Start", "%Delay = {0.5}, Wait", "Ready") +
                      rule("Ready", "%notify_message = {\"Follow me.\"}, Notified", "Next"))));
  Percept call;
  call.heard = {Word("Follow me.")};
  static_cast<void>(robot.see());
  static_cast<void>(robot.see(call));
  for (int tick = 2; tick <= 6; ++tick) static_cast<void>(robot.see());
  EXPECT_EQ(robot.state(), "Next");
}

TEST(MissionTriggers, SignalsFadeAndOthersDoNotCount) {
  const std::string heard = "%notify_message = {\"Follow me.\"}, Notified";
  Percept other;
  other.heard = {Word("Cover me.")};
  EXPECT_FALSE(fires(heard, other));
  MissionRobot robot(mission_of(
      last(state("Start", "Stop") + state("Ready", "Stop") + state("Next", "Stop") +
           rule("Start", "%Delay = {2.0}, Wait", "Ready") + rule("Ready", heard, "Next"))));
  Percept call;
  call.heard = {Word("Follow me.")};
  static_cast<void>(robot.see(call));
  for (int tick = 1; tick <= 30; ++tick) static_cast<void>(robot.see());
  EXPECT_EQ(robot.state(), "Ready");
}

TEST(MissionTriggers, TheOperatorsWords) {
  Percept word;
  word.operated.proceed = true;
  EXPECT_TRUE(fires("Proceed", word));
  EXPECT_FALSE(fires("SkipGoal", word));
  EXPECT_TRUE(fires("TelopComplete", word));
  word.operated.teleoperated = true;
  EXPECT_FALSE(fires("TelopComplete", word));
  word.operated = {false, {}, false, true};
  EXPECT_TRUE(fires("SkipGoal", word));
}

TEST(MissionTriggers, MovementCountsFromWhereTheStateWasEntered) {
  const std::string mission =
      mission_of(last(state("Start", "Stop") + state("Go", "Stop") + state("Next", "Stop") +
                      rule("Start", "Immediate", "Go") +
                      rule("Go", "%Desired_distance = {2.0}, MovedDistance", "Next")));
  MissionRobot robot(mission);
  static_cast<void>(robot.see(at(5.0, 0.0)));
  static_cast<void>(robot.see(at(5.0, 0.0)));
  static_cast<void>(robot.see(at(6.9, 0.0)));
  EXPECT_EQ(robot.state(), "Go");
  static_cast<void>(robot.see(at(7.0, 0.0)));
  EXPECT_EQ(robot.state(), "Next");
}

TEST(MissionTriggers, TurnsCountEitherWay) {
  EXPECT_FALSE(fires("%Angle = {90}, HasTurned", at(0, 0, 89)));
  EXPECT_TRUE(fires("%Angle = {90}, HasTurned", at(0, 0, 91)));
  EXPECT_TRUE(fires("%Angle = {90}, HasTurned", at(0, 0, -91)));
  EXPECT_FALSE(fires("AboutFaceCompleted", at(0, 0, 170)));
  EXPECT_TRUE(fires("AboutFaceCompleted", at(0, 0, -176)));
}

TEST(MissionTriggers, NoProgressNeedsItsTime) {
  MissionRobot robot(
      mission_of(last(state("Start", "Stop") + state("Stuck", "Stop") +
                      rule("Start", "%Distance = {0.1}, %Delay = {2.0}, NoProgress", "Stuck"))));
  for (int tick = 0; tick < 30; ++tick) {  // On the way.
    static_cast<void>(robot.see(at(0.04 * tick, 0.0)));
    EXPECT_EQ(robot.state(), "Start");
  }
  for (int tick = 0; tick < 19; ++tick) static_cast<void>(robot.see(at(1.16, 0.0)));
  EXPECT_EQ(robot.state(), "Stuck");
}

TEST(MissionTriggers, EveryOneThatIsKnownCanBeMade) {
  const std::string parameters =
      "%Objects = {Mines}, %Goal_Location = {3, 4}, %Distance = {0.5}, %Delay = {1.0}, "
      "%notify_message = {\"Hi\"}, %direction = {Left}, %Desired_distance = {1.0}, ";
  for (const std::string& word : triggers_known()) {
    EXPECT_NO_THROW(static_cast<void>(fires(parameters + word, {}))) << word;
  }
}

}  // namespace
}  // namespace tacit
