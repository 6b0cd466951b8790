#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "tests/world/sample_worlds.h"

namespace tacit {
namespace {

constexpr RobotId kFirst{1};

ViewedRobot robot_of(const World& world, std::size_t index = 0) {
  WorldView view;
  world.view(view);
  return view.robots.at(index);
}

double speed(const World& world) { return robot_of(world).velocity_mps.norm(); }

std::vector<Command> order(const World& world, const BodyVec& velocity_mps, double turn = 0.0) {
  return {{kFirst, world.tick(), velocity_mps, turn}};
}

TEST(Robots, TakeUpTheVelocityTheyWant) {
  const WorldConfig config = empty_world(1);
  World world(config, 1);
  for (int i = 0; i < 20; ++i) {
    world.step(order(world, {1.0, 0.5}));
  }
  EXPECT_NEAR(world.percepts()[0].velocity_mps.x(), 1.0, 1e-12);
  EXPECT_NEAR(world.percepts()[0].velocity_mps.y(), 0.5, 1e-12);
}

TEST(Robots, NeverGoFasterThanTheirWheels) {
  const WorldConfig config = empty_world(1);
  World world(config, 1);
  for (int i = 0; i < 60; ++i) {
    world.step(order(world, {100.0, 30.0}));
    ASSERT_LE(speed(world), config.robots.max_speed_mps * (1.0 + 1e-12));
  }
  EXPECT_NEAR(speed(world), config.robots.max_speed_mps, 1e-9);
}

TEST(Robots, NeverAccelerateMoreThanTheirWheelsDo) {
  const WorldConfig config = empty_world(1);
  const double most = config.robots.max_acceleration_mps2 * config.physics.tick_s;
  World world(config, 1);
  Stream chance(1, "commands");
  WorldVec before;
  for (int i = 0; i < 300; ++i) {
    const auto events = world.step(
        order(world, {chance.uniform(-9, 9), chance.uniform(-9, 9)}, chance.uniform(-3, 3)));
    ASSERT_TRUE(events.empty() || std::holds_alternative<Checkpoint>(events[0].what));
    const WorldVec now = robot_of(world).velocity_mps;
    ASSERT_LE((now - before).norm(), most * (1.0 + 1e-9));
    before = now;
  }
}

TEST(Robots, NeverTurnFasterThanTheirWheels) {
  const WorldConfig config = empty_world(1);
  const double most = config.robots.max_turn_radps * config.physics.tick_s;
  for (const double wanted : {1e6, -1e6}) {
    World world(config, 1);
    const double before = robot_of(world).pose.heading.rad();
    world.step(order(world, {}, wanted));
    const double turned = wrapped_rad(robot_of(world).pose.heading.rad() - before);
    EXPECT_NEAR(turned, wanted > 0.0 ? most : -most, 1e-12);
  }
}

TEST(Robots, TurnByTheRateTimesTheTick) {
  World world(empty_world(1), 1);
  const double before = robot_of(world).pose.heading.rad();
  for (int i = 0; i < 10; ++i) {
    world.step(order(world, {}, 0.3));
  }
  EXPECT_NEAR(robot_of(world).pose.heading.rad() - before, 0.3, 1e-12);
}

TEST(Robots, BrakeAndStandWithoutACommand) {
  const WorldConfig config = empty_world(1);
  World world(config, 1);
  for (int i = 0; i < 10; ++i) {
    world.step(order(world, {2.0, 0.0}));
  }
  double before = speed(world);
  ASSERT_NEAR(before, 2.0, 1e-9);
  const double brake = config.robots.max_acceleration_mps2 * config.physics.tick_s;
  while (before > 0.0) {
    world.step({});
    ASSERT_NEAR(speed(world), std::max(0.0, before - brake), 1e-9);
    before = speed(world);
  }
  const WorldVec place = robot_of(world).pose.position_m;
  world.step({});
  EXPECT_EQ(robot_of(world).pose.position_m, place);
}

TEST(Robots, WithoutACommandDoNotHinderTheOthers) {
  World world(empty_world(2), 1);
  for (int i = 0; i < 10; ++i) {
    world.step(order(world, {1.0, 0.0}));
  }
  EXPECT_NEAR(robot_of(world, 0).velocity_mps.norm(), 1.0, 1e-9);
  EXPECT_EQ(robot_of(world, 1).velocity_mps, WorldVec{});
}

TEST(Robots, MoveTheWayTheyFaceWhenToldToGoAhead) {
  World world(empty_world(4), 1);
  const ViewedRobot start = robot_of(world, 1);
  for (int i = 0; i < 10; ++i) {
    world.step(std::vector<Command>{{RobotId{2}, world.tick(), {1.0, 0.0}, 0.0}});
  }
  const WorldVec moved = robot_of(world, 1).pose.position_m - start.pose.position_m;
  EXPECT_NEAR(unit(moved).x(), start.pose.heading.cos, 1e-9);
  EXPECT_NEAR(unit(moved).y(), start.pose.heading.sin, 1e-9);
}

TEST(Percepts, CarryOdometryThatComposesToTheTrueMotion) {
  const WorldConfig config = busy_world(5);
  World world(config, 3);
  Stream chance(1, "commands");
  std::vector<WorldPose> starts;
  for (std::size_t i = 0; i < 5; ++i) {
    starts.push_back(robot_of(world, i).pose);
  }
  for (Tick tick = 0; tick < 300; ++tick) {
    world.step(random_commands(5, tick, chance));
    for (std::size_t i = 0; i < 5; ++i) {
      const OdometryPose& own = world.percepts()[i].odometry;
      const WorldPose truth = robot_of(world, i).pose;
      const WorldVec moved = from_body<WorldFrame>(starts[i].heading, BodyVec{own.position_m.xy});
      ASSERT_NEAR((starts[i].position_m + moved - truth.position_m).norm(), 0.0, 1e-12);
      const double turned = own.heading.rad() + starts[i].heading.rad();
      ASSERT_NEAR(wrapped_rad(turned - truth.heading.rad()), 0.0, 1e-12);
    }
  }
}

TEST(Percepts, CarryTheOwnVelocityInTheBodyFrame) {
  World world(busy_world(5), 3);
  Stream chance(1, "commands");
  for (Tick tick = 0; tick < 100; ++tick) {
    world.step(random_commands(5, tick, chance));
    for (std::size_t i = 0; i < 5; ++i) {
      const ViewedRobot truth = robot_of(world, i);
      const BodyVec expected = to_body(truth.pose.heading, truth.velocity_mps);
      ASSERT_EQ(world.percepts()[i].velocity_mps, expected);
    }
  }
}

TEST(Percepts, StartAtTheOriginOfTheirOdometry) {
  const World world(busy_world(5), 3);
  for (const Percept& percept : world.percepts()) {
    EXPECT_EQ(percept.odometry.position_m, OdometryVec{});
    EXPECT_NEAR(percept.odometry.heading.cos, 1.0, 1e-15);
    EXPECT_NEAR(percept.odometry.heading.sin, 0.0, 1e-15);
    EXPECT_EQ(percept.velocity_mps, BodyVec{});
    EXPECT_FALSE(percept.touching);
  }
}

// Robot 1 starts 10 m east of the target and faces east; the obstacle is dead ahead.
WorldConfig blocked_ahead() {
  WorldConfig config = empty_world(1);
  config.obstacles.discs = {{65.0, 50.0, 2.0}};
  return config;
}

TEST(Collisions, AreToldOnceWhileARobotKeepsPressing) {
  World world(blocked_ahead(), 1);
  std::vector<Collision> told;
  for (int i = 0; i < 200; ++i) {
    for (const Event& event : world.step(order(world, {2.0, 0.0}))) {
      if (const auto* collision = std::get_if<Collision>(&event.what)) {
        told.push_back(*collision);
      }
    }
  }
  ASSERT_EQ(told.size(), 1u);
  EXPECT_EQ(told[0], (Collision{kFirst, Obstruction::Obstacle, 0}));
}

TEST(Collisions, PressTheBumper) {
  World world(blocked_ahead(), 1);
  bool touched = false;
  for (int i = 0; i < 200; ++i) {
    const bool told = !world.step(order(world, {2.0, 0.0})).empty();
    touched = touched || world.percepts()[0].touching;
    ASSERT_TRUE(touched || !told || i % 100 == 99);
  }
  EXPECT_TRUE(touched);
}

TEST(Collisions, ReleaseTheBumperWhenTheRobotLeaves) {
  World world(blocked_ahead(), 1);
  for (int i = 0; i < 50; ++i) {
    world.step(order(world, {2.0, 0.0}));
  }
  for (int i = 0; i < 20; ++i) {
    world.step(order(world, {-2.0, 0.0}));
  }
  EXPECT_FALSE(world.percepts()[0].touching);
}

TEST(Collisions, OfTwoRobotsPressBothBumpersAndAreToldOnce) {
  WorldConfig config = empty_world(2);
  config.robots.ring_radius_m = 5.0;
  World world(config, 1);
  std::vector<Event> told;
  bool both = false;
  for (int i = 0; i < 60; ++i) {
    // They face outwards on opposite sides and back into each other.
    const std::vector<Command> commands{{RobotId{1}, world.tick(), {-2.0, 0.0}, 0.0},
                                        {RobotId{2}, world.tick(), {-2.0, 0.0}, 0.0}};
    const auto events = world.step(commands);
    told.insert(told.end(), events.begin(), events.end());
    both = both || (world.percepts()[0].touching && world.percepts()[1].touching);
  }
  EXPECT_TRUE(both);
  ASSERT_EQ(told.size(), 1u);
  EXPECT_EQ(std::get<Collision>(told[0].what), (Collision{RobotId{1}, Obstruction::Robot, 2}));
}

TEST(Collisions, WithTheBorderNameTheWall) {
  WorldConfig config = empty_world(1);
  config.robots.ring_radius_m = 48.0;
  World world(config, 1);
  std::vector<Event> told;
  for (int i = 0; i < 60; ++i) {
    const auto events = world.step(order(world, {2.0, 0.0}));
    told.insert(told.end(), events.begin(), events.end());
  }
  ASSERT_EQ(told.size(), 1u);
  EXPECT_EQ(std::get<Collision>(told[0].what).with, Obstruction::Wall);
}

TEST(Collisions, InAnySubstepPressTheBumper) {
  WorldConfig config = blocked_ahead();
  config.physics.substeps = 10;
  World world(config, 1);
  int collisions = 0;
  for (int i = 0; i < 60; ++i) {
    for (const Event& event : world.step(order(world, {2.0, 0.0}))) {
      collisions += static_cast<int>(std::holds_alternative<Collision>(event.what));
    }
  }
  EXPECT_EQ(collisions, 1);
}

}  // namespace
}  // namespace tacit
