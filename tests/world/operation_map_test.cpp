#include <gtest/gtest.h>

#include "tests/world/operation_field.h"
#include "world_server/world/missions/operation_map.h"

namespace tacit {
namespace {

// How far north a robot comes that goes straight ahead from the hallway for 4 s.
double north_of(double x_m, const std::string& doors = "open") {
  WorldConfig config = on_floor({{x_m, 5.0, 90.0}});
  config.area.doors = doors;
  Field field(config);
  repeat(field, 40, {acting(1, Act::None, {1.0, 0.0})});
  return field.place(1).y();
}

TEST(OperationMap, LetsARobotThroughADoor) { EXPECT_GT(north_of(6.0), 8.0); }
TEST(OperationMap, StopsARobotAtAWall) { EXPECT_LT(north_of(3.0), 6.0); }
TEST(OperationMap, StopsARobotAtAClosedDoor) { EXPECT_LT(north_of(6.0, "closed"), 6.0); }

TEST(OperationMap, LetsARobotThroughAGap) {
  Field field(on_floor({{16.0, 5.0, -90.0}}));
  repeat(field, 40, {acting(1, Act::None, {1.0, 0.0})});
  EXPECT_LT(field.place(1).y(), 3.0);
}

TEST(OperationMap, EndsTheAreaWhereItSays) {
  Field field(on_floor({{18.0, 5.0, 0.0}}));
  repeat(field, 40, {acting(1, Act::None, {1.0, 0.0})});
  EXPECT_LT(field.place(1).x(), 20.0);
  EXPECT_TRUE(field.percept(1).touching);
}

TEST(OperationMap, HasObstaclesThatRobotsBumpInto) {
  Field field(on_floor({{2.0, 5.0, 0.0}}, "OBSTACLE 5 5 0.5\n"));
  repeat(field, 40, {acting(1, Act::None, {1.0, 0.0})});
  EXPECT_LT(field.place(1).x(), 4.5);
  EXPECT_FALSE(field.percept(1).obstacles.empty());
}

TEST(OperationMap, TakenTwiceIsTakenOnce) {
  WorldConfig config = on_floor({{2.0, 5.0, 0.0}}, "OBSTACLE 5 5 0.5\n");
  const MapPlan plan = operation_plan(config);
  take_ground(plan, config);
  const auto walls = config.area.walls;
  ASSERT_FALSE(walls.empty());
  take_ground(plan, config);
  EXPECT_EQ(config.area.walls, walls);
  EXPECT_EQ(config.obstacles.discs, (std::vector<std::vector<double>>{{5.0, 5.0, 0.5}}));
  EXPECT_EQ(config.area.width_m, 20.0);
  EXPECT_EQ(config.area.height_m, 12.0);
}

TEST(OperationMap, KeepsTheScenariosOwnWalls) {
  WorldConfig config = on_floor({{2.0, 5.0, 0.0}});
  config.area.walls = {{8.0, 4.0, 8.0, 6.0}};
  Field field(config);
  repeat(field, 100, {acting(1, Act::None, {1.0, 0.0})});
  EXPECT_LT(field.place(1).x(), 8.0);
}

TEST(OperationMap, WithErrorsIsRefusedWithTheirPlaces) {
  const std::string said = refusal(on_floor({{2.0, 5.0, 0.0}}, "OBSTACLE 1 x\nWALL w 1\n"));
  EXPECT_NE(said.find("[operation] map:15:"), std::string::npos) << said;
  EXPECT_NE(said.find("[operation] map:16:"), std::string::npos) << said;
}

TEST(OperationMap, WithAColourThatNobodyKnowsIsRefusedWithItsPlace) {
  const std::string said = refusal(on_floor({{2.0, 5.0, 0.0}}, "OBJECT 3 5 0.3 Fixed mauve\n"));
  EXPECT_NE(said.find("[operation] map:15:1: error: found an object of colour \"mauve\""),
            std::string::npos)
      << said;
}

TEST(OperationMap, WithThingsThatNoPerceptCouldTellIsRefused) {
  for (const char* thing :
       {"DOOR d -1e9 5 1e9 5\n", "OBJECT 5 5 2e4 Fixed brown\n", "OBJECT 1e7 5 1 Fixed brown\n",
        "HALLWAY k CENTERLINE 0 1 1e7 1 WIDTH 1 EXTENTS 0 0 9 0 9 2\n",
        "HALLWAY k CENTERLINE 0 1 9 1 WIDTH 1e5 EXTENTS 0 0 9 0 9 2\n",
        "HALLWAY k CENTERLINE 0 1 1e5 1 0 1 1e5 1 WIDTH 1 EXTENTS 0 0 9 0 9 2\n"}) {
    const std::string said = refusal(on_floor({{2.0, 5.0, 0.0}}, thing));
    EXPECT_NE(said.find("wanted places within 200000 m"), std::string::npos) << thing << said;
  }
}

TEST(OperationMap, KnowsMissionLabsColours) {
  EXPECT_EQ(map_colour("DarkSeaGreen"), Colour::SeaGreen);
  EXPECT_EQ(map_colour("lightblue"), Colour::LightBlue);
  EXPECT_EQ(map_colour("BROWN"), Colour::Brown);
  EXPECT_EQ(map_colour(""), std::nullopt);
}

TEST(OperationMap, MayBeMissing) {
  WorldConfig config = on_floor({{150.0, 150.0, 0.0}});
  config.operation.script.map.clear();
  Field field(config);
  field.step({acting(1, Act::Mark)});
  EXPECT_EQ(field.percept(1).site, Site::Open);
  EXPECT_TRUE(field.all<DoorwayMarked>().empty());
}

// Without an area the world's origin is 1 m south-west of everything.
TEST(OperationMap, CountsStartsInItsOwnFrame) {
  WorldConfig config = on_floor({{-10.0, -10.0, 0.0}});
  config.operation.script.map = "CONTROL MEASURES:\nPP p -12 -12\nPP q 30 30\n";
  const Field field(config);
  EXPECT_EQ(field.place(1), (WorldVec{3.0, 3.0}));
}

TEST(Starts, StandWhereTheScriptSays) {
  const Field field(on_floor({{2.0, 5.0, 0.0}, {4.0, 5.0, 90.0}}));
  EXPECT_EQ(field.place(2), (WorldVec{4.0, 5.0}));
  EXPECT_NEAR(field.view.robots[1].pose.heading.sin, 1.0, 1e-12);
}

struct BadStart {
  Starts starts;
  std::string said;
};

TEST(Starts, ThatAreNotFreeAreRefusedByRobot) {
  const std::vector<BadStart> bad{
      {{{2.0, 5.0, 0.0}, {3.0, 6.05, 0.0}}, "robot 2 at 3.000000, 6.050000: a wall"},
      {{{2.0, 5.0, 0.0}, {2.3, 5.0, 0.0}}, "robot 2 at 2.300000, 5.000000: another robot"},
      {{{25.0, 5.0, 0.0}}, "robot 1 at 25.000000, 5.000000: it is outside"},
      {{{0.1, 5.0, 0.0}}, "robot 1 at 0.100000, 5.000000: it is outside"}};
  for (const BadStart& each : bad) {
    const std::string said = refusal(on_floor(each.starts));
    EXPECT_NE(said.find("[operation] starts: " + each.said), std::string::npos) << said;
  }
}

TEST(Starts, AreOnePerRobot) {
  WorldConfig config = on_floor({{2.0, 5.0, 0.0}});
  config.robots.count = 2;
  EXPECT_EQ(refusal(config),
            "[operation] starts: found 1 rows, wanted one for each of the 2 robots");
}

TEST(Extras, LeaveAtLeastOneRobotToTheTeam) {
  EXPECT_NE(refusal(with_extras(on_floor({{2.0, 5.0, 0.0}}), 1)).find("extra_count = 1"),
            std::string::npos);
}

TEST(Obstacles, PlacedByChanceKeepFromTheStarts) {
  WorldConfig config = on_floor({{18.0, 2.0, 0.0}});
  config.obstacles = {3.0, 0.2, 0.5, 1.5, 0, {}};
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const World world(config, seed);
    for (const SeenObstacle& disc : world.percepts()[0].obstacles) {
      if (disc.radius_m > 0.0) {
        EXPECT_GE(disc.offset_m.norm() - disc.radius_m, 1.5);
      }
    }
  }
}

}  // namespace
}  // namespace tacit
