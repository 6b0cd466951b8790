#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "tests/world/forage_field.h"

namespace tacit {
namespace {

WorldConfig hunted(std::int64_t robots, std::int64_t hunters = 1, std::int64_t wait = 0) {
  WorldConfig config = bare_field(robots);
  config.forage.hunters.count = hunters;
  config.forage.hunters.min_wait_ticks = wait;
  config.forage.hunters.max_wait_ticks = wait;
  return config;
}

double from_border_m(const WorldVec& p) {
  return std::min({p.x(), p.y(), 40.0 - p.x(), 40.0 - p.y()});
}

// A world that keeps count of what every hunter outside is about.
struct Hunt : Field {
  using Field::Field;

  void go(const std::vector<Command>& commands = {}) {
    step(commands);
    for (const EnemyCreated& event : all<EnemyCreated>()) {
      hunting.insert(event.enemy);
    }
    for (const RobotDisabled& event : all<RobotDisabled>()) {
      disabled.push_back(event);
    }
  }
  [[nodiscard]] WorldVec hunter() const { return view.enemies.at(0).position_m; }

  std::set<EnemyId> hunting;
  std::vector<RobotDisabled> disabled;
};

// Until the only hunter has touched the only robot but one.
Hunt after_a_touch(std::uint64_t seed = 1) {
  Hunt hunt(hunted(2), seed);
  while (hunt.disabled.empty()) {
    hunt.go();
  }
  return hunt;
}

TEST(Hunters, ComeOutAtTheRimWhenTheirWaitIsOver) {
  Field field(hunted(1, 3, 10));
  for (Tick tick = 0; tick < 10; ++tick) {
    field.step();
    ASSERT_TRUE(field.told.empty());
  }
  field.step();
  const auto created = field.all<EnemyCreated>();
  ASSERT_EQ(created.size(), 3u);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(created[i].enemy.value, i + 1);
    EXPECT_EQ(created[i].kind, EnemyKind::Hunter);
    EXPECT_NEAR(from_border_m(created[i].position_m), 0.4, 1e-12);
  }
  EXPECT_EQ(field.told[0].tick, 10u);
  EXPECT_EQ(field.view.enemies.size(), 3u);
  EXPECT_EQ(seen(field.percept(1), Kind::Enemy, Colour::Red), 3);
}

TEST(Hunters, WaitAnyTimeBetweenTheLimits) {
  std::set<Tick> waits;
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    WorldConfig config = hunted(1);
    config.forage.hunters.min_wait_ticks = 5;
    config.forage.hunters.max_wait_ticks = 9;
    Field field(config, seed);
    while (field.told.empty()) {
      field.step();
    }
    waits.insert(field.told[0].tick);
  }
  EXPECT_EQ(waits, (std::set<Tick>{5, 6, 7, 8, 9}));
}

TEST(Hunters, HideOnEverySide) {
  int sides[4] = {};
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    Field field(hunted(1), seed);
    field.step();
    const WorldVec p = field.all<EnemyCreated>().at(0).position_m;
    const double off[4] = {p.y(), 40.0 - p.x(), 40.0 - p.y(), p.x()};
    ++sides[std::min_element(off, off + 4) - off];
  }
  for (const int side : sides) {
    EXPECT_NEAR(side, 50, 5 * std::sqrt(200.0 * 0.25 * 0.75));
  }
}

TEST(Hunters, GoForTheNearestAbleRobotAtTheirSpeed) {
  WorldConfig config = hunted(5);
  config.robots.ring_radius_m = 12.0;
  int steps = 0;
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    Field field(config, seed);
    field.step();
    bool hunting = true;
    while (hunting && !field.world.over()) {
      field.step();
      const WorldVec from = field.before.enemies.at(0).position_m;
      WorldVec nearest{1e9, 1e9};
      for (const ViewedRobot& robot : field.before.robots) {
        const WorldVec way = robot.pose.position_m - from;
        nearest = robot.able && way.norm() < nearest.norm() ? way : nearest;
      }
      hunting = field.all<RobotDisabled>().empty();
      const WorldVec moved = field.view.enemies.at(0).position_m - from;
      if (nearest.norm() > 1.0) {
        ASSERT_NEAR(moved.norm(), 0.25, 1e-9);
        ASSERT_LE(std::abs(unit(moved).cross(unit(nearest))), 0.31);
        ASSERT_GT(moved.dot(nearest), 0.0);
        ++steps;
      }
    }
  }
  EXPECT_GT(steps, 100);
}

TEST(Hunters, PassByADisabledRobotOnTheWayToAnAbleOne) {
  Hunt hunt(hunted(3), 3);
  while (hunt.disabled.size() < 2 && !hunt.world.over()) {
    hunt.go();
  }
  EXPECT_NE(hunt.disabled.at(0).robot, hunt.disabled.at(1).robot);
}

TEST(Hunters, DisableTheFirstAbleRobotWithinTheirTouch) {
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    Hunt hunt = after_a_touch(seed);
    EXPECT_EQ(hunt.disabled[0].by, Mishap::Enemy);
    const auto distance_m = [](const WorldView& view, RobotId robot) {
      return (view.robots[robot.value - 1u].pose.position_m - view.enemies.at(0).position_m).norm();
    };
    EXPECT_LE(distance_m(hunt.view, hunt.disabled[0].robot), 0.5);
    EXPECT_GT(distance_m(hunt.before, hunt.disabled[0].robot), 0.5);
  }
}

TEST(Hunters, TouchOneRobotAtATime) {
  WorldConfig config = hunted(4);
  config.robots.ring_radius_m = 0.3;
  config.forage.hunters.contact_m = 2.0;
  Hunt hunt(config);
  while (hunt.disabled.empty()) {
    hunt.go();
  }
  EXPECT_EQ(hunt.disabled.size(), 1u);
}

TEST(Hunters, RetreatToTheRimAndHideThere) {
  Hunt hunt = after_a_touch();
  while (hunt.all<EnemyRetreated>().empty()) {
    hunt.go();
    ASSERT_LT(hunt.world.tick(), 1000u);
  }
  EXPECT_EQ(hunt.all<EnemyRetreated>()[0].enemy, EnemyId{1});
  EXPECT_TRUE(hunt.view.enemies.empty());
  EXPECT_LE(from_border_m(hunt.before.enemies.at(0).position_m), 0.4 + 0.5 + 0.25);
}

TEST(Hunters, ComeOutWhereTheyWentIntoHidingAfterAnotherWait) {
  WorldConfig config = hunted(2, 1, 7);
  Hunt hunt(config);
  while (hunt.all<EnemyRetreated>().empty()) {
    hunt.go();
  }
  const WorldVec last = hunt.before.enemies.at(0).position_m;
  const Tick hidden = hunt.world.tick();
  while (hunt.all<EnemyCreated>().empty()) {
    hunt.go();
  }
  EXPECT_EQ(hunt.told[0].tick, hidden + 7);
  EXPECT_EQ(hunt.all<EnemyCreated>()[0].enemy, EnemyId{2});
  EXPECT_LE((hunt.all<EnemyCreated>()[0].position_m - last).norm(), 0.5 + 0.25);
}

TEST(Hunters, HarmNobodyWhileTheyRetreat) {
  WorldConfig config = hunted(12);
  config.robots.ring_radius_m = 0.8;
  int passed = 0;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    Hunt hunt(config, seed);
    while (hunt.disabled.empty()) {
      hunt.go();
    }
    while (hunt.all<EnemyRetreated>().empty()) {
      hunt.go();
      ASSERT_EQ(hunt.disabled.size(), 1u);
      for (const ViewedRobot& robot : hunt.view.robots) {
        passed += static_cast<int>(robot.able && !hunt.view.enemies.empty() &&
                                   (robot.pose.position_m - hunt.hunter()).norm() <= 0.5);
      }
    }
  }
  EXPECT_GT(passed, 10);
}

std::vector<Command> all_at(std::int64_t robots, Act act) {
  std::vector<Command> commands;
  for (std::uint16_t i = 1; i <= robots; ++i) {
    commands.push_back(acting(i, act));
  }
  return commands;
}

TEST(HunterInterception, DestroysAHunterAsFarAsItsReachAndNoFurther) {
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    Field field(hunted(2), seed);
    while (field.all<EnemyIntercepted>().empty()) {
      field.step(all_at(2, Act::Intercept));
      for (const ViewedEnemy& hunter : field.view.enemies) {
        ASSERT_GT((hunter.position_m - field.place(1)).norm(), 1.0);
        ASSERT_GT((hunter.position_m - field.place(2)).norm(), 1.0);
      }
    }
    const EnemyIntercepted event = field.all<EnemyIntercepted>()[0];
    EXPECT_EQ(event.enemy, EnemyId{1});
    EXPECT_EQ(event.kind, EnemyKind::Hunter);
    EXPECT_TRUE(field.percept(event.robot.value).deeds.intercepted);
    EXPECT_FALSE(field.percept(3u - event.robot.value).deeds.intercepted);
    // The robots stand 2 m from the base.
    EXPECT_LE(event.distance_to_target_m, 3.0);
    EXPECT_GE(event.distance_to_target_m, 1.0);
    EXPECT_TRUE(field.view.enemies.empty());
  }
}

TEST(HunterInterception, NeedsTheAct) {
  for (const Act act : {Act::None, Act::PickUp, Act::Drop, Act::Aid}) {
    Field field(hunted(1));
    while (!field.world.over()) {
      field.step(all_at(1, act));
      ASSERT_TRUE(field.all<EnemyIntercepted>().empty());
    }
  }
}

TEST(HunterInterception, ComesBeforeTheTouchOfTheSameStep) {
  WorldConfig config = hunted(2);
  config.forage.reach.intercept_m = 0.5;
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    Hunt hunt(config, seed);
    while (hunt.all<EnemyIntercepted>().empty()) {
      hunt.go(all_at(2, Act::Intercept));
    }
    EXPECT_TRUE(hunt.disabled.empty());
  }
}

TEST(HunterInterception, GoesToTheNearestRobot) {
  WorldConfig config = hunted(6);
  config.forage.reach.intercept_m = 6.0;
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    Field field(config, seed);
    field.step();
    while (field.all<EnemyIntercepted>().empty()) {
      field.step(all_at(6, Act::Intercept));
    }
    // The hunter is gone: judge by where it was one step before, give or take its step.
    const WorldVec last = field.before.enemies.at(0).position_m;
    const std::size_t by = field.all<EnemyIntercepted>()[0].robot.value;
    for (std::size_t i = 1; i <= 6; ++i) {
      EXPECT_LE((field.place(by) - last).norm(), (field.place(i) - last).norm() + 0.5);
    }
  }
}

TEST(HunterInterception, ReachesARetreatingHunter) {
  WorldConfig config = hunted(2);
  config.forage.reach.intercept_m = 20.0;
  Hunt hunt(config);
  while (hunt.disabled.empty()) {
    hunt.go();
  }
  const std::uint16_t other = hunt.disabled[0].robot.value == 1 ? 2 : 1;
  hunt.go({acting(other, Act::Intercept)});
  EXPECT_EQ(hunt.all<EnemyIntercepted>().size(), 1u);
}

TEST(HunterInterception, BringsAnotherHunterAfterAnotherWait) {
  WorldConfig config = hunted(1, 1, 9);
  Field field(config);
  while (field.all<EnemyIntercepted>().empty()) {
    field.step(all_at(1, Act::Intercept));
  }
  const Tick gone = field.world.tick();
  while (field.all<EnemyCreated>().empty()) {
    field.step();
  }
  EXPECT_EQ(field.told[0].tick, gone + 9);
  EXPECT_EQ(field.all<EnemyCreated>()[0].enemy, EnemyId{2});
  EXPECT_NEAR(from_border_m(field.all<EnemyCreated>()[0].position_m), 0.4, 1e-12);
}

TEST(HunterInterception, ByADisabledRobotDoesNotHappen) {
  WorldConfig config = hunted(2);
  config.forage.reach.intercept_m = 30.0;
  Hunt hunt(config);
  while (hunt.disabled.empty()) {
    hunt.go();
  }
  hunt.go({acting(hunt.disabled[0].robot.value, Act::Intercept)});
  EXPECT_TRUE(hunt.all<EnemyIntercepted>().empty());
}

TEST(ForageDigest, CoversHuntersInHiding) {
  EXPECT_NE(World(hunted(1, 1, 50), 1).digest(), World(hunted(1, 1, 51), 1).digest());
}

TEST(ForageCheckpoint, CountsHuntersOutside) {
  WorldConfig config = hunted(1, 3);
  config.physics.checkpoint_ticks = 1;
  Field field(config);
  field.step();
  EXPECT_EQ(field.all<Checkpoint>().at(0).enemies, 3u);
}

}  // namespace
}  // namespace tacit
