#include <gtest/gtest.h>

#include "tests/world/forage_field.h"
#include "world_server/world/missions/mud.h"

namespace tacit {
namespace {

// Robots get stuck now and then.
WorldConfig muddy(std::int64_t robots, double per_tick = 0.05) {
  WorldConfig config = bare_field(robots);
  config.forage.mud.per_tick = per_tick;
  return config;
}

// Steps, with every robot at `act`, until a robot is stuck and another is not; then `stuck` holds.
struct Stuck {
  explicit Stuck(const WorldConfig& config, Act act = Act::None) : field(config) {
    std::vector<Command> commands;
    for (std::uint16_t i = 1; i <= config.robots.count; ++i) {
      commands.push_back(acting(i, act));
    }
    while (field.all<RobotDisabled>().empty()) {
      field.step(commands);
    }
    stuck = field.all<RobotDisabled>()[0].robot.value;
    other = stuck == 1 ? 2 : 1;
  }
  [[nodiscard]] const ViewedRobot& robot() const { return field.view.robots[stuck - 1u]; }

  Field field;
  std::uint16_t stuck = 0;
  std::uint16_t other = 0;
};

TEST(Mud, CountsOnlyTheTicksInWhichARobotIsAble) {
  WorldConfig config = muddy(3, 0.2);
  config.robots.ring_radius_m = 0.25;
  Field field(config, 5);
  Mud mud(0.2, 5, 3);
  int mishaps = 0;
  for (int tick = 0; tick < 200 && !field.world.over(); ++tick) {
    field.step({acting(1, Act::Aid), acting(2, Act::Aid), acting(3, Act::Aid)});
    std::vector<RobotDisabled> expected;
    for (std::size_t i = 0; i < 3; ++i) {
      if (field.before.robots[i].able && mud.sticks(i)) {
        expected.push_back({field.view.robots[i].robot, Mishap::Mud});
      }
    }
    ASSERT_EQ(field.all<RobotDisabled>(), expected);
    mishaps += static_cast<int>(expected.size());
  }
  EXPECT_GT(mishaps, 5);
}

TEST(DisabledRobots, AreToldAndFeltAndSeenYellow) {
  const Stuck mishap(muddy(2));
  EXPECT_EQ(mishap.field.all<RobotDisabled>(),
            (std::vector<RobotDisabled>{{RobotId{mishap.stuck}, Mishap::Mud}}));
  EXPECT_FALSE(mishap.field.percept(mishap.stuck).able);
  EXPECT_FALSE(mishap.robot().able);
  EXPECT_TRUE(mishap.field.percept(mishap.other).able);
  EXPECT_EQ(seen(mishap.field.percept(mishap.other), Kind::Teammate, Colour::Yellow), 1);
  EXPECT_EQ(seen(mishap.field.percept(mishap.stuck), Kind::Teammate, Colour::Blue), 1);
}

TEST(DisabledRobots, StopAtOnceAndAreDeafToCommands) {
  WorldConfig config = muddy(2);
  Field field(config);
  const std::vector<Command> go{acting(1, Act::PickUp, {0.1, 0.0}),
                                acting(2, Act::PickUp, {0.1, 0.0})};
  while (field.all<RobotDisabled>().empty()) {
    field.step(go);
  }
  const std::uint16_t stuck = field.all<RobotDisabled>()[0].robot.value;
  const ViewedRobot robot = field.view.robots[stuck - 1u];
  EXPECT_EQ(robot.velocity_mps, WorldVec{});
  EXPECT_EQ(field.percept(stuck).velocity_mps, BodyVec{});
  field.step({{RobotId{stuck}, 0, {0.5, 0.0}, 1.0, Act::None}});
  EXPECT_EQ(field.place(stuck), robot.pose.position_m);
  EXPECT_EQ(field.view.robots[stuck - 1u].pose.heading.sin, robot.pose.heading.sin);
}

// The robots stand 1 m apart and face outwards, so that backing drives one into the other.
TEST(DisabledRobots, AreNotPushedAlong) {
  WorldConfig config = muddy(2, 0.02);
  config.robots.ring_radius_m = 0.5;
  Stuck mishap(config);
  const WorldVec place = mishap.robot().pose.position_m;
  bool touched = false;
  for (int i = 0; i < 10; ++i) {
    mishap.field.step({acting(mishap.other, Act::None, {-0.5, 0.0})});
    touched = touched || mishap.field.percept(mishap.stuck).touching;
    ASSERT_EQ(mishap.field.place(mishap.stuck), place);
  }
  EXPECT_TRUE(touched);
}

TEST(DisabledRobots, LoseTheMineThatTheyHold) {
  WorldConfig config = muddy(1, 0.02);
  config.forage.mines.places = {{22.1, 20.0}};
  Field field(config);
  field.step({acting(1, Act::PickUp)});
  ASSERT_TRUE(field.percept(1).holding);
  while (!field.world.over()) {
    field.step({acting(1, Act::None, {0.1, 0.0})});
  }
  EXPECT_EQ(field.all<MineDropped>(),
            (std::vector<MineDropped>{{RobotId{1}, MineId{1}, field.place(1)}}));
  EXPECT_TRUE(field.percept(1).deeds.dropped);
  EXPECT_FALSE(field.percept(1).holding);
  EXPECT_EQ(field.view.mines.size(), 1u);
}

TEST(DisabledRobots, LoseAMineEvenAtTheBase) {
  WorldConfig config = muddy(1, 0.1);
  config.robots.ring_radius_m = 0.5;
  config.forage.mines.places = {{20.5, 20.0}};
  Field field(config);
  field.step({acting(1, Act::PickUp)});
  ASSERT_TRUE(field.percept(1).holding);
  while (!field.world.over()) {
    field.step();
  }
  EXPECT_EQ(field.all<MineDropped>().size(), 1u);
  EXPECT_EQ(field.all<MineStored>().size(), 0u);
}

TEST(DisabledRobots, DoNothingBesideMoving) {
  WorldConfig config = muddy(2);
  config.forage.mines.places = {{22.1, 20.0}, {17.9, 20.0}};
  Stuck mishap(config);
  mishap.field.step({acting(mishap.stuck, Act::PickUp)});
  EXPECT_TRUE(mishap.field.all<MineTaken>().empty());
}

TEST(ForageMission, IsLostWhenEveryRobotIsDisabledAndScoresTheCap) {
  WorldConfig config = muddy(3, 1.0);
  config.forage.cap_ticks = 5000;
  Field field(config);
  field.step();
  EXPECT_TRUE(field.world.over());
  ASSERT_EQ(field.told.size(), 4u);
  EXPECT_EQ(field.told.back(), (Event{1, MissionOver{Verdict::TeamLost, 5000}}));
}

WorldConfig muddy_and_close(std::int64_t robots, double ring_radius_m) {
  WorldConfig config = muddy(robots, 0.02);
  config.robots.ring_radius_m = ring_radius_m;
  return config;
}

TEST(Aid, RevivesATeammateInReach) {
  Stuck mishap(muddy_and_close(2, 0.25));
  mishap.field.step({acting(mishap.other, Act::Aid)});
  EXPECT_EQ(mishap.field.all<RobotRevived>(),
            (std::vector<RobotRevived>{{RobotId{mishap.stuck}, RobotId{mishap.other}}}));
  EXPECT_TRUE(mishap.field.percept(mishap.stuck).able);
  EXPECT_TRUE(mishap.field.percept(mishap.other).deeds.revived);
  EXPECT_FALSE(mishap.field.percept(mishap.stuck).deeds.revived);
  EXPECT_EQ(seen(mishap.field.percept(mishap.other), Kind::Teammate, Colour::Blue), 1);
}

TEST(Aid, ReachesAsFarAsItsReachAndNoFurther) {
  for (const double apart_m : {0.5, 0.51}) {
    Stuck mishap(muddy_and_close(2, 0.5 * apart_m));
    mishap.field.step({acting(mishap.other, Act::Aid)});
    EXPECT_EQ(mishap.field.all<RobotRevived>().size(), apart_m <= 0.5 ? 1u : 0u);
  }
}

TEST(Aid, DoesNotComeInTheStepOfTheMishap) {
  const Stuck mishap(muddy_and_close(2, 0.25), Act::Aid);
  EXPECT_TRUE(mishap.field.all<RobotRevived>().empty());
  EXPECT_FALSE(mishap.robot().able);
}

TEST(Aid, MustBeMeantWhenTheRulesSaySo) {
  Stuck mishap(muddy_and_close(2, 0.25));
  mishap.field.step({acting(mishap.other, Act::PickUp)});
  EXPECT_TRUE(mishap.field.all<RobotRevived>().empty());
}

TEST(Aid, IsAnyTouchWhenTheRulesSaySo) {
  WorldConfig config = muddy_and_close(2, 0.25);
  config.forage.reach.revival_needs_aid = false;
  Stuck mishap(config);
  mishap.field.step();
  EXPECT_EQ(mishap.field.all<RobotRevived>(),
            (std::vector<RobotRevived>{{RobotId{mishap.stuck}, RobotId{mishap.other}}}));
  EXPECT_TRUE(mishap.field.percept(mishap.other).deeds.revived);
}

// Three robots in a triangle with sides of 0.45 m.
TEST(Aid, OfEquallyNearHelpersIsTheLowestNumbers) {
  Stuck mishap(muddy_and_close(3, 0.45 / std::sqrt(3.0)));
  mishap.field.step({acting(1, Act::Aid), acting(2, Act::Aid), acting(3, Act::Aid)});
  const auto revived = mishap.field.all<RobotRevived>();
  ASSERT_EQ(revived.size(), 1u);
  const auto distance_m = [&](std::size_t i) {
    return (mishap.field.place(i) - mishap.field.place(mishap.stuck)).norm();
  };
  std::size_t nearest = mishap.other;
  for (std::size_t i = 1; i <= 3; ++i) {
    if (i != mishap.stuck && distance_m(i) < distance_m(nearest)) {
      nearest = i;
    }
  }
  EXPECT_EQ(revived[0].by.value, nearest);
}

TEST(Aid, LetsARobotStartFromStandstillAndGoOn) {
  Stuck mishap(muddy_and_close(2, 0.25));
  mishap.field.step({acting(mishap.other, Act::Aid), acting(mishap.stuck, Act::None, {0.2, 0.0})});
  EXPECT_EQ(mishap.robot().velocity_mps, WorldVec{});
  mishap.field.step({acting(mishap.stuck, Act::None, {0.2, 0.0})});
  EXPECT_NEAR(mishap.robot().velocity_mps.norm(), 0.2, 1e-12);
}

// In a row of three, the middle one helps one neighbour; the other end is out of the first's reach.
TEST(Aid, OfOneWhoWasDisabledHimselfDoesNotCount) {
  WorldConfig config = muddy(6, 0.3);
  config.robots.ring_radius_m = 0.45;
  config.forage.reach.revival_needs_aid = false;
  int revived = 0;
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    Field field(config, seed);
    while (!field.world.over() && field.world.tick() < 50) {
      field.step();
      for (const RobotRevived& event : field.all<RobotRevived>()) {
        ASSERT_TRUE(field.before.robots[event.by.value - 1u].able);
        ASSERT_TRUE(field.view.robots[event.by.value - 1u].able);
        ASSERT_FALSE(field.before.robots[event.robot.value - 1u].able);
        ++revived;
      }
    }
  }
  EXPECT_GT(revived, 100);
}

TEST(ForageDigest, CoversWhoIsDisabled) {
  WorldConfig config = muddy(1, 1.0);
  Field stuck(config);
  config.forage.mud.per_tick = 0.0;
  Field free(config);
  stuck.step();
  free.step();
  EXPECT_NE(stuck.world.digest(), free.world.digest());
}

}  // namespace
}  // namespace tacit
