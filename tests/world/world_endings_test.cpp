#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <vector>

#include "tests/world/sample_worlds.h"

namespace tacit {
namespace {

// One robot on the target while enemies come from the west; no obstacles.
WorldConfig guarded() {
  WorldConfig config = empty_world(1);
  config.robots.ring_radius_m = 0.0;
  config.enemies.strategy = 2;
  return config;
}

// One robot far off in the east, so that nobody is in the enemies' way.
WorldConfig unguarded() {
  WorldConfig config = guarded();
  config.robots.ring_radius_m = 45.0;
  return config;
}

// The endings of a run in which the robots only stand.
template <class Ending>
std::vector<Ending> endings(const WorldConfig& config, Tick ticks = 1500) {
  World world(config, 7);
  std::vector<Ending> found;
  for (Tick tick = 0; tick < ticks; ++tick) {
    for (const Event& event : world.step({})) {
      if (const auto* ending = std::get_if<Ending>(&event.what)) {
        found.push_back(*ending);
      }
    }
  }
  return found;
}

double stride_m(const WorldConfig& config) {
  return config.enemies.speed_mps * config.physics.tick_s;
}

TEST(Hit, HappensAtTheFirstTickWithinTheHitRadius) {
  WorldConfig config = unguarded();
  config.enemies.hit_radius_m = 3.0;
  const std::vector<TargetHit> hits = endings<TargetHit>(config);
  ASSERT_GT(hits.size(), 10u);
  for (const TargetHit& hit : hits) {
    EXPECT_LE(hit.distance_to_target_m, 3.0);
    EXPECT_GT(hit.distance_to_target_m, 3.0 - stride_m(config));
  }
}

TEST(Interception, HappensAtTheFirstTickWithinTheKillRadius) {
  WorldConfig config = guarded();
  config.enemies.kill_radius_m = 3.0;
  config.enemies.hit_radius_m = 1.0;
  const std::vector<EnemyIntercepted> kills = endings<EnemyIntercepted>(config);
  ASSERT_GT(kills.size(), 10u);
  for (const EnemyIntercepted& kill : kills) {
    // The robot stands on the target.
    EXPECT_LE(kill.distance_to_target_m, 3.0);
    EXPECT_GT(kill.distance_to_target_m, 3.0 - stride_m(config));
    EXPECT_EQ(kill.robot, RobotId{1});
    EXPECT_EQ(kill.kind, EnemyKind::Normal);
  }
}

TEST(Interception, WinsOverAHitInTheSameTick) {
  WorldConfig config = guarded();
  config.enemies.kill_radius_m = 2.5;
  config.enemies.hit_radius_m = 2.5;
  EXPECT_GT(endings<EnemyIntercepted>(config).size(), 10u);
  EXPECT_TRUE(endings<TargetHit>(config).empty());
}

TEST(Interception, GoesToTheNearestRobot) {
  WorldConfig config = guarded();
  config.robots.count = 2;
  config.robots.ring_radius_m = 0.5;
  config.enemies.kill_radius_m = 4.0;
  const std::vector<EnemyIntercepted> kills = endings<EnemyIntercepted>(config);
  ASSERT_GT(kills.size(), 10u);
  for (const EnemyIntercepted& kill : kills) {
    // Robot 2 stands in the west.
    EXPECT_EQ(kill.robot, RobotId{2});
  }
}

TEST(Interception, ReachesDecoysToo) {
  WorldConfig config = guarded();
  config.enemies.strategy = 3;
  config.robots.ring_radius_m = 0.0;
  config.target = {12.0, 50.0, 1.0};
  config.enemies.kill_radius_m = 10.0;
  bool decoy = false;
  for (const EnemyIntercepted& kill : endings<EnemyIntercepted>(config)) {
    decoy = decoy || kill.kind == EnemyKind::Decoy;
  }
  EXPECT_TRUE(decoy);
}

TEST(Enemies, AliveAreOutOfEveryRobotsAndTheTargetsReach) {
  const WorldConfig config = busy_world(4);
  World world(config, 7);
  Stream chance(1, "commands");
  WorldView view;
  for (Tick tick = 0; tick < 1000; ++tick) {
    world.step(random_commands(4, tick, chance));
    world.view(view);
    for (const ViewedEnemy& enemy : view.enemies) {
      ASSERT_GT((enemy.position_m - WorldVec{30.0, 30.0}).norm(), config.enemies.hit_radius_m);
      for (const ViewedRobot& robot : view.robots) {
        ASSERT_GT((enemy.position_m - robot.pose.position_m).norm(), config.enemies.kill_radius_m);
      }
    }
  }
}

TEST(Enemies, DieOnlyOfARobotThatCouldReachThem) {
  const WorldConfig config = busy_world(4);
  World world(config, 7);
  Stream chance(1, "commands");
  WorldView view;
  std::map<EnemyId, WorldVec> last_seen;
  int kills = 0;
  for (Tick tick = 0; tick < 1000; ++tick) {
    for (const Event& event : world.step(random_commands(4, tick, chance))) {
      if (const auto* created = std::get_if<EnemyCreated>(&event.what)) {
        last_seen[created->enemy] = created->position_m;
      }
      if (const auto* kill = std::get_if<EnemyIntercepted>(&event.what)) {
        world.view(view);
        const WorldVec robot = view.robots[kill->robot.value - 1u].pose.position_m;
        ASSERT_LE((robot - last_seen.at(kill->enemy)).norm(),
                  config.enemies.kill_radius_m + stride_m(config) + 0.05);
        ++kills;
      }
    }
    world.view(view);
    for (const ViewedEnemy& enemy : view.enemies) {
      last_seen[enemy.enemy] = enemy.position_m;
    }
  }
  EXPECT_GT(kills, 5);
}

TEST(Enemies, ReachTheTargetOnNearlyStraightLines) {
  WorldConfig config = unguarded();
  config.enemies.noise_gain = 0.0;
  config.enemies.spawn_jitter_m = 0.0;
  World world(config, 7);
  // Half the area less the inset, or its diagonal, at 1.7 m/s.
  const auto longest = static_cast<Tick>(std::sqrt(2.0) * 50.0 / stride_m(config)) + 1;
  std::map<EnemyId, Tick> created;
  int hits = 0;
  for (Tick tick = 0; tick < 2000; ++tick) {
    for (const Event& event : world.step({})) {
      if (const auto* enemy = std::get_if<EnemyCreated>(&event.what)) {
        created[enemy->enemy] = event.tick;
      } else if (const auto* hit = std::get_if<TargetHit>(&event.what)) {
        ASSERT_LE(event.tick - created.at(hit->enemy), longest);
        ++hits;
      }
    }
  }
  EXPECT_GT(hits, 20);
}

TEST(Enemies, GetRoundAnObstacleInTheirWay) {
  for (const double radius_m : {1.0, 3.0, 5.0}) {
    WorldConfig config = unguarded();
    config.obstacles.discs = {{25.0, 50.0, radius_m}, {30.0, 30.0, radius_m}};
    World world(config, 7);
    WorldView view;
    std::map<EnemyId, Tick> created;
    Tick slowest = 0;
    for (Tick tick = 0; tick < 4000; ++tick) {
      for (const Event& event : world.step({})) {
        if (const auto* enemy = std::get_if<EnemyCreated>(&event.what)) {
          created[enemy->enemy] = event.tick;
        } else if (const auto* hit = std::get_if<TargetHit>(&event.what)) {
          slowest = std::max(slowest, event.tick - created.at(hit->enemy));
          created.erase(hit->enemy);
        }
      }
    }
    // Nobody is left behind who has had three times the straight way's time.
    const auto patience = static_cast<Tick>(3.0 * std::sqrt(2.0) * 50.0 / stride_m(config));
    EXPECT_LT(slowest, patience) << radius_m;
    for (const auto& [enemy, tick] : created) {
      EXPECT_GT(tick + patience, world.tick()) << "radius " << radius_m << " enemy " << enemy.value;
    }
  }
}

TEST(Decoys, NeverComeNearTheTarget) {
  WorldConfig config = unguarded();
  config.enemies.strategy = 4;
  World world(config, 7);
  WorldView view;
  for (Tick tick = 0; tick < 3000; ++tick) {
    world.step({});
    world.view(view);
    for (const ViewedEnemy& enemy : view.enemies) {
      ASSERT_TRUE(enemy.kind == EnemyKind::Normal ||
                  (enemy.position_m - WorldVec{50.0, 50.0}).norm() >
                      50.0 - config.enemies.decoy_tether_m - config.enemies.spawn_jitter_m);
    }
  }
}

}  // namespace
}  // namespace tacit
