#include <gtest/gtest.h>

#include "robot_agent/brain/mission/behaviours.h"
#include "tests/brain/mission_robot.h"

namespace tacit {
namespace {

using testing::last;
using testing::mission_of;
using testing::MissionRobot;
using testing::rule;
using testing::state;

/// A robot in a state that does `behaviour`; its next answer is the first of that state.
MissionRobot doing(const std::string& behaviour, std::vector<double> start = {0.0, 0.0, 0.0}) {
  MissionRobot robot(mission_of(last(state("Start", behaviour) + rule("Start", "Never", "Start"))),
                     start);
  static_cast<void>(robot.see());
  return robot;
}

Percept with(std::vector<Sighting> sightings) {
  Percept percept;
  percept.sightings = std::move(sightings);
  return percept;
}

Sighting object(Colour colour, double x, double y, double radius_m = 0.25) {
  return {Kind::Object, colour, {x, y}, radius_m};
}

/// In a hallway along the body's x axis, `left_m` left of the robot.
Percept in_hallway(double ahead_m, double behind_m, double left_m = 0.0) {
  Percept percept;
  percept.site = Site::Hallway;
  percept.hallway = SeenHallway{{0.0, left_m}, {1.0, 0.0}, ahead_m, behind_m, 2.0};
  return percept;
}

void expect_near(const BodyVec& found, double x, double y, double tolerance = 1e-9) {
  EXPECT_NEAR(found.x(), x, tolerance);
  EXPECT_NEAR(found.y(), y, tolerance);
}

constexpr const char* kFree =
    "%avoid_obstacle_gain = {1.0}, %avoid_obstacle_sphere = {1.2}, "
    "%avoid_obstacle_safety_margin = {0.3}, ";

TEST(MissionBehaviours, GoToPullsToAPlaceOnTheMapFromWhereTheRobotStarted) {
  MissionRobot robot = doing("%Goal_Location = {10, 5}, GoTo", {10.0, 1.0, 90.0});
  expect_near(robot.see().velocity_mps, 1.0, 0.0);
  Percept turned;
  turned.odometry.heading = Heading::from_rad(-0.5 * kPi);  // Now facing east on the map.
  expect_near(robot.see(turned).velocity_mps, 0.0, 1.0);
}

TEST(MissionBehaviours, GoToWeighsItsGains) {
  MissionRobot robot = doing("%Goal_Location = {10, 0}, %move_to_location_gain = {0.5}, GoTo");
  expect_near(robot.see().velocity_mps, 0.5, 0.0);
}

TEST(MissionBehaviours, MovingKeepsOffObstaclesAndRobots) {
  const std::string go = "%Goal_Location = {10, 0}, " + std::string(kFree) + "GoTo";
  Percept wall;
  wall.obstacles = {{{0.75, 0.0}, 0.0}};  // Half way between sphere and margin.
  expect_near(doing(go).see(wall).velocity_mps, 0.5, 0.0);
  const Percept mate = with({{Kind::Teammate, Colour::Blue, {0.95, 0.0}, 0.2}});
  // Half of the push goes away from it, half past it on the right.
  expect_near(doing(go).see(mate).velocity_mps, 0.75, -0.25);
}

TEST(MissionBehaviours, MovingFollowsTheJoystickBeside) {
  Percept steered;
  steered.operated = {true, {0.0, 0.5}, false, false};
  expect_near(doing("%Goal_Location = {10, 0}, GoTo").see(steered).velocity_mps, 1.0, 0.5);
  expect_near(doing("Telop").see(steered).velocity_mps, 0.0, 0.5);
}

TEST(MissionBehaviours, MoveTowardPullsToTheNearestOfItsClasses) {
  const Percept two = with({object(Colour::Orange, 0.0, 5.0), object(Colour::Purple, 3.0, 0.0),
                            object(Colour::Brown, 1.0, 0.0)});
  expect_near(doing("%Objects = {Mines}, MoveToward").see(two).velocity_mps, 0.0, 1.0);
  expect_near(doing("%Objects = {Mines | Flags}, MoveToward").see(two).velocity_mps, 1.0, 0.0);
  expect_near(doing("%Objects = {Enemies}, MoveToward").see(two).velocity_mps, 0.0, 0.0);
}

TEST(MissionBehaviours, MoveTowardGoesNoFartherThanItSees) {
  const Percept far = with({object(Colour::Orange, 60.0, 0.0)});
  expect_near(doing("%Objects = {Mines}, MoveToward").see(far).velocity_mps, 0.0, 0.0);
}

TEST(MissionBehaviours, MoveAwayPushesWithinTheSphere) {
  const std::string away =
      "%Objects = {Mines}, %avoid_objects_sphere = {2.0}, %avoid_objects_safety_margin = {1.0}, "
      "%wander_gain = {0.0}, MoveAway";
  expect_near(doing(away).see(with({object(Colour::Orange, 1.75, 0.0)})).velocity_mps, -0.5, 0.0);
  expect_near(doing(away).see(with({object(Colour::Orange, 3.0, 0.0)})).velocity_mps, 0.0, 0.0);
}

TEST(MissionBehaviours, FollowStopsAtADistance) {
  const std::string follow =
      "%Objects = {Friendly_Robots}, %follow_distance = {2.0}, %avoid_obstacle_gain = {0.0}, "
      "Follow";
  const auto mate = [](double x) { return with({{Kind::Teammate, Colour::Blue, {x, 0.0}, 0.2}}); };
  expect_near(doing(follow).see(mate(5.0)).velocity_mps, 1.0, 0.0);
  expect_near(doing(follow).see(mate(2.25)).velocity_mps, 0.5, 0.0);
  expect_near(doing(follow).see(mate(1.5)).velocity_mps, 0.0, 0.0);
}

TEST(MissionBehaviours, MoveAheadKeepsTheWayThatItBeganWith) {
  MissionRobot robot = doing("MoveAhead");
  expect_near(robot.see().velocity_mps, 1.0, 0.0);
  Percept turned;
  turned.odometry.heading = Heading::from_rad(0.5 * kPi);
  expect_near(robot.see(turned).velocity_mps, 0.0, -1.0);
}

TEST(MissionBehaviours, WanderPullsToOpenGround) {
  Percept walled;  // All the front is barred within two metres.
  for (const double angle : {-1.0, -0.5, 0.0, 0.5, 1.0}) {
    walled.obstacles.push_back({{1.6 * std::cos(angle), 1.6 * std::sin(angle)}, 0.0});
  }
  const std::string wander = "%curious = {1.0}, %cautious = {0.0}, Wander";
  const BodyVec barred = doing(wander).see(walled).velocity_mps;
  const BodyVec open = doing(wander).see().velocity_mps;
  // Noise is the same in both; the difference is the open ground's pull, straight on or aside.
  const BodyVec change = open - barred;
  EXPECT_GT(change.x(), 0.9);
  EXPECT_LT(std::abs(barred.y() - open.y()), 1.0);
}

TEST(MissionBehaviours, AboutFaceTurnsHalfWayRoundOnTheSpot) {
  MissionRobot robot = doing("AboutFace");
  const Command first = robot.see();
  expect_near(first.velocity_mps, 0.0, 0.0);
  EXPECT_GT(std::abs(first.turn_radps), 1.0);
  Percept done;
  done.odometry.heading = Heading::from_rad(kPi - 0.01);
  EXPECT_LT(std::abs(robot.see(done).turn_radps), 0.05);
}

TEST(MissionBehaviours, StopStandsStill) {
  for (const char* still : {"Stop", "WaitForProceed", "Localize"}) {
    const Command command = doing(still).see(in_hallway(5, 5));
    expect_near(command.velocity_mps, 0.0, 0.0);
    EXPECT_EQ(command.act, Act::None) << still;
  }
}

TEST(MissionBehaviours, ProceedAlongHallwayGoesAsItFacesAndKeepsToTheCentre) {
  const std::string along = "%proceed_direction = {Facing}, ProceedAlongHallway";
  expect_near(doing(along).see(in_hallway(10, 10)).velocity_mps, 1.0, 0.0);
  // A metre off the line of a hallway two metres wide: half strength.
  expect_near(doing(along).see(in_hallway(10, 10, 1.0)).velocity_mps, 1.0, 0.5);
  expect_near(doing(along).see(in_hallway(0, 10)).velocity_mps, 0.0, 0.0);
  expect_near(doing(along).see().velocity_mps, 0.0, 0.0);
}

TEST(MissionBehaviours, ProceedAlongHallwayTurnsLeftOrRightOutOfARoom) {
  Percept across;
  across.site = Site::Hallway;
  across.hallway = SeenHallway{{0.0, 0.0}, {0.0, -1.0}, 10.0, 10.0, 2.0};
  const auto along = [&](const std::string& way) {
    return doing("%proceed_direction = {" + way + "}, ProceedAlongHallway").see(across);
  };
  expect_near(along("Left").velocity_mps, 0.0, 1.0);
  expect_near(along("Right").velocity_mps, 0.0, -1.0);
}

TEST(MissionBehaviours, ProceedAlongHallwayFacingAcrossKeepsTheCourse) {
  MissionRobot robot = doing("%proceed_direction = {Facing}, ProceedAlongHallway");
  MissionRobot fresh = doing("%proceed_direction = {Facing}, ProceedAlongHallway");
  Percept across;
  across.site = Site::Hallway;
  across.odometry.heading = Heading::from_rad(0.5 * kPi);
  across.hallway = SeenHallway{{0.0, 0.0}, {0.0, 1.0}, 10.0, 10.0, 2.0};
  static_cast<void>(robot.see(in_hallway(10, 10)));  // It goes along its x axis: a course.
  expect_near(robot.see(across).velocity_mps, 0.0, -1.0);
  expect_near(fresh.see(across).velocity_mps, 0.0, 1.0);  // Without a course one way is as good.
}

SeenDoorway doorway(double x, double y, bool marked = false) {
  return {{x, y}, {0.75, 0.0}, marked};
}

TEST(MissionBehaviours, EnterRoomGoesThroughTheNearestDoorwayWithoutAMark) {
  Percept doors;
  doors.site = Site::Hallway;
  doors.doorways = {doorway(0.0, 1.0, true), doorway(0.0, -2.0)};
  const std::string gains = "%avoid_obstacles_gain = {0.0}, EnterRoom";
  expect_near(doing(gains).see(doors).velocity_mps, 0.0, -1.0);
  expect_near(doing("%enter_which = {ENTER_ANY}, " + gains).see(doors).velocity_mps, 0.0, 1.0);
}

TEST(MissionBehaviours, EnterRoomGoesOnBeyondTheDoorway) {
  MissionRobot robot =
      doing("%distance_to_enter = {1.0}, %avoid_obstacles_gain = {0.0}, EnterRoom");
  Percept before;
  before.doorways = {doorway(0.0, 1.0)};
  expect_near(robot.see(before).velocity_mps, 0.0, 1.0);
  Percept inside;  // Half a metre past the doorway; it looks back at it.
  inside.odometry.position_m = {0.0, 1.5};
  inside.doorways = {doorway(0.0, -0.5)};
  expect_near(robot.see(inside).velocity_mps, 0.0, 1.0);
  Percept beyond;
  beyond.odometry.position_m = {0.0, 2.5};
  expect_near(robot.see(beyond).velocity_mps, 0.0, -1.0);
}

TEST(MissionBehaviours, EnterRoomComesToASlantingDoorwayFromTheFront) {
  Percept aside;
  aside.doorways = {doorway(3.0, 1.0)};
  const BodyVec way = doing("%avoid_obstacles_gain = {0.0}, EnterRoom").see(aside).velocity_mps;
  EXPECT_NEAR(way.y() / way.x(), 0.5 / 3.0, 1e-9);  // To half a metre before its middle.
}

TEST(MissionBehaviours, LeaveRoomGoesOutWhereItCameIn) {
  MissionRobot robot = doing("%avoid_obstacles_gain = {0.0}, LeaveRoom");
  MissionRobot other = doing("%avoid_obstacles_gain = {0.0}, LeaveRoom");
  Percept came_in;
  came_in.site = Site::Room;
  came_in.doorways = {doorway(0.0, -0.5)};
  static_cast<void>(robot.see(came_in));
  Percept two;
  two.site = Site::Room;
  two.doorways = {doorway(0.0, 1.0), doorway(0.0, -2.0)};
  expect_near(other.see(two).velocity_mps, 0.0, 1.0);
  expect_near(robot.see(two).velocity_mps, 0.0, -1.0);
}

TEST(MissionBehaviours, LeaveRoomFindsTheWayOutOfALargeRoom) {
  const std::string mission =
      mission_of(last(state("Start", "%avoid_obstacles_gain = {0.0}, EnterRoom") +
                      state("Out", "%avoid_obstacles_gain = {0.0}, LeaveRoom") +
                      rule("Start", "%Delay = {0.3}, Wait", "Out")));
  MissionRobot robot(mission);
  Percept before;
  before.site = Site::Hallway;
  before.doorways = {doorway(0.0, 1.0)};
  Percept inside;
  inside.site = Site::Room;
  inside.odometry.position_m = {0.0, 1.2};
  inside.doorways = {doorway(0.0, -0.2)};
  Percept far;  // The doorway is too far to be seen.
  far.site = Site::Room;
  far.odometry.position_m = {0.0, 15.0};
  for (const Percept& percept : {before, inside, far, far}) static_cast<void>(robot.see(percept));
  EXPECT_EQ(robot.state(), "Out");
  expect_near(robot.see(far).velocity_mps, 0.0, -1.0);
}

TEST(MissionBehaviours, ActsAreDoneInTheirStates) {
  EXPECT_EQ(doing("%Objects = {Mines}, PickUp").see().act, Act::PickUp);
  EXPECT_EQ(doing("%Objects = {Mines}, PickUp").see().about, Colour::Orange);
  EXPECT_EQ(doing("%Object = {Mine}, PutInEOD").see().act, Act::Drop);
  EXPECT_EQ(doing("%Object = {Enemies}, TerminateObject").see().act, Act::Intercept);
  EXPECT_EQ(doing("Terminate").see().act, Act::Finish);
  EXPECT_EQ(doing("TerminateMission").see().act, Act::FinishAll);
  EXPECT_EQ(doing("MarkDoorway").see().act, Act::Mark);
  EXPECT_EQ(doing("UnmarkDoorway").see().act, Act::Unmark);
}

TEST(MissionBehaviours, SignalsAndAlertsAreGivenOnce) {
  for (const auto& [text, act] :
       {std::pair{"%notify_message = {\"Cover me.\"}, NotifyRobots", Act::Signal},
        std::pair{"%alert_subject = {\"Cover me.\"}, Alert", Act::Alert}}) {
    MissionRobot robot = doing(text);
    const Command first = robot.see();
    EXPECT_EQ(first.act, act);
    EXPECT_EQ(first.word.text(), "Cover me.");
    EXPECT_EQ(robot.see().act, Act::None);
  }
}

TEST(MissionBehaviours, TestObjectProbesForASecond) {
  MissionRobot robot = doing("TestObject");
  for (int tick = 1; tick < 10; ++tick) EXPECT_EQ(robot.see().act, Act::None) << tick;
  EXPECT_EQ(robot.see().act, Act::Test);
}

TEST(MissionBehaviours, SurveyRoomTestsEverySuspectAndSaysWhatItFound) {
  const std::string mission = mission_of(
      last(state("Start", "SurveyRoom*") + state("Bad", "Stop") + state("Good", "Stop") +
           rule("Start", "%notify_message = {\"TARGET FOUND\"}, TaskExited", "Bad") +
           rule("Start", "%notify_message = {\"NO TARGET FOUND\"}, TaskExited", "Good")));
  const Percept suspect = with({object(Colour::Brown, 3.0, 0.0, 0.5)});
  const Percept near = with({object(Colour::Brown, 0.55, 0.0, 0.5)});
  for (const Finding finding : {Finding::Dangerous, Finding::Harmless}) {
    MissionRobot robot(mission);
    static_cast<void>(robot.see(suspect));
    static_cast<void>(robot.see(suspect));
    EXPECT_EQ(robot.state(), "Start/MoveToward");
    expect_near(robot.see(suspect).velocity_mps, 1.0, 0.0);
    static_cast<void>(robot.see(near));
    EXPECT_EQ(robot.state(), "Start/TestObject");
    Command command = robot.see(near);
    for (int tick = 0; tick < 20 && command.act != Act::Test; ++tick) command = robot.see(near);
    EXPECT_EQ(command.about, Colour::Brown);
    Percept tested = with({object(Colour::Grey, 0.55, 0.0, 0.5)});
    tested.deeds.tested = finding;
    static_cast<void>(robot.see(tested));
    for (int tick = 0; tick < 3; ++tick) {
      static_cast<void>(robot.see(with({object(Colour::Grey, 0.55, 0.0, 0.5)})));
    }
    EXPECT_EQ(robot.state(), finding == Finding::Dangerous ? "Bad" : "Good");
  }
}

TEST(MissionBehaviours, SurveyRoomMeansTheSameByTheWordsOf2000) {
  const std::string mission = mission_of(
      last(state("Start", "SurveyRoom*") + state("Good", "Stop") +
           rule("Start", "%notify_message = {\"NO BIOHAZARD DETECTED\"}, TaskExited", "Good")));
  MissionRobot robot(mission);
  for (int tick = 0; tick < 4; ++tick) static_cast<void>(robot.see());
  EXPECT_EQ(robot.state(), "Good");
}

TEST(MissionBehaviours, StandbyEndsWithTheOperatorsWord) {
  const std::string mission =
      mission_of(last(state("Start", "Standby*") + state("Go", "Stop") +
                      rule("Start", "%notify_message = {\"PROCEED MISSION\"}, TaskExited", "Go")));
  MissionRobot robot(mission);
  for (int tick = 0; tick < 5; ++tick) static_cast<void>(robot.see());
  EXPECT_EQ(robot.state(), "Start/Wait");
  Percept word;
  word.operated.proceed = true;
  static_cast<void>(robot.see(word));
  static_cast<void>(robot.see());
  EXPECT_EQ(robot.state(), "Go");
}

TEST(MissionBehaviours, FormationsPutEachRobotInItsPlace) {
  // Two robots in line, 4 m apart, heading east: the first stands in the middle, the second 4 m to
  // its left, so their centre is 2 m left of the first.
  const std::string one = mission_of(
      last(state("Start",
                 "%formation = {Line}, %spacing = {4.0}, %Goal_Location = {1000, 0}, "
                 "%move_to_location_gain = {0.0}, %dead_zone = {0.0}, %saturation = {1.0}, "
                 "%avoid_obstacle_gain = {0.0}, MoveInFormation") +
           rule("Start", "Never", "Start")));
  std::string two = one;
  two.replace(two.find("[ $AN_2 ]"), 9, "[ $AN_2, $AN_2 ]");
  BrainConfig config = MissionRobot::config(two, {0.0, 0.0, 0.0});
  config.script.starts.push_back({0.0, 1.0, 0.0});
  const auto answer = [&config](std::uint16_t robot, double mate_y) {
    Brain brain(config, RobotId{robot}, 7);
    Percept percept = with({{Kind::Teammate, Colour::Blue, {0.0, mate_y}, 0.2}});
    percept.robot = {robot};
    static_cast<void>(brain.decide(percept));
    percept.tick = 1;
    return brain.decide(percept).velocity_mps;
  };
  // A metre apart, each is pulled outwards with all its strength.
  expect_near(answer(1, 1.0), 0.0, -1.0, 0.02);
  expect_near(answer(2, -1.0), 0.0, 1.0, 0.02);
  expect_near(answer(1, 4.0), 0.0, 0.0, 0.02);
}

TEST(MissionBehaviours, EveryOneThatIsKnownCanBeMade) {
  const std::string parameters =
      "%Objects = {Mines}, %Object = {Mines}, %Goal_Location = {3, 4}, %notify_message = {\"Hi\"}, "
      "%alert_subject = {\"Hi\"}, ";
  for (const std::string& word : behaviours_known()) {
    MissionRobot robot = doing(parameters + word);
    static_cast<void>(robot.see());
    EXPECT_EQ(robot.state().substr(0, 5), "Start") << word;
  }
}

}  // namespace
}  // namespace tacit
