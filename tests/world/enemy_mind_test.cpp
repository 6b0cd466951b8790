#include "world_server/world/enemies/enemy_mind.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "tests/world/sample_worlds.h"

namespace tacit {
namespace {

Enemy an_enemy(EnemyKind kind, const WorldVec& place_m, std::uint64_t seed = 1) {
  return {EnemyId{1}, kind, 0, place_m, {Stream(seed, "enemy heading", 1), {}, 0}};
}

struct Field {
  WorldConfig config = empty_world(1);
  Terrain terrain{100.0, 100.0, true, {}, {}};
  WorldVec place_m{10.0, 30.0};

  Field() { config.enemies.noise_gain = 0.0; }

  [[nodiscard]] WorldVec velocity(EnemyKind kind = EnemyKind::Normal) const {
    EnemyMind mind(config, terrain);
    Enemy enemy = an_enemy(kind, place_m);
    return mind.velocity(enemy, place_m, 0);
  }
  [[nodiscard]] WorldVec straight() const {
    return config.enemies.speed_mps *
           unit(WorldVec{config.target.x_m, config.target.y_m} - place_m);
  }
  [[nodiscard]] bool goes_straight() const { return (velocity() - straight()).norm() < 1e-12; }
};

TEST(NormalEnemies, GoStraightToATargetInSight) { EXPECT_TRUE(Field().goes_straight()); }

TEST(NormalEnemies, SwerveNoMoreThanTheirNoiseAllows) {
  Field field;
  field.config.enemies.noise_gain = 0.15;
  EnemyMind mind(field.config, field.terrain);
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    Enemy enemy = an_enemy(EnemyKind::Normal, field.place_m, seed);
    const WorldVec velocity = mind.velocity(enemy, field.place_m, 0);
    const double sine = unit(velocity).cross(unit(field.straight()));
    ASSERT_LE(std::abs(sine), 0.15 + 1e-12);
    ASSERT_GT(velocity.dot(field.straight()), 0.0);
  }
}

TEST(NormalEnemies, WanderWhenAWallHidesTheTarget) {
  Field field;
  field.terrain.walls = {{{30.0, 0.0}, {30.0, 100.0}}};
  EXPECT_FALSE(field.goes_straight());
  field.config.enemies.sight_blocked_by_walls = false;
  EXPECT_TRUE(field.goes_straight());
}

TEST(NormalEnemies, WanderWhenAnObstacleHidesTheTargetAndObstaclesBlock) {
  Field field;
  field.terrain.obstacles = {{{30.0, 40.0}, 3.0}};
  EXPECT_TRUE(field.goes_straight());
  field.config.enemies.sight_blocked_by_obstacles = true;
  EXPECT_FALSE(field.goes_straight());
}

TEST(NormalEnemies, WanderBeyondTheirSight) {
  Field field;
  field.config.enemies.sight_range_m = 44.0;
  EXPECT_FALSE(field.goes_straight());
  field.config.enemies.sight_range_m = 45.0;
  EXPECT_TRUE(field.goes_straight());
}

TEST(WanderingEnemies, HoldAHeadingForItsTimeAndThenTakeAnother) {
  const Field field;
  EnemyMind mind(field.config, field.terrain);
  Enemy enemy = an_enemy(EnemyKind::Decoy, field.place_m);
  const auto hold =
      static_cast<Tick>(field.config.enemies.wander_hold_s / field.config.physics.tick_s);
  std::set<std::pair<double, double>> headings;
  for (Tick tick = 0; tick < 4 * hold; ++tick) {
    const WorldVec velocity = mind.velocity(enemy, field.place_m, tick);
    headings.insert({velocity.x(), velocity.y()});
    ASSERT_EQ(headings.size(), tick / hold + 1);
  }
}

TEST(WanderingEnemies, TakeEveryDirection) {
  const Field field;
  EnemyMind mind(field.config, field.terrain);
  std::set<int> quadrants;
  for (std::uint64_t seed = 1; seed <= 50; ++seed) {
    Enemy enemy = an_enemy(EnemyKind::Decoy, field.place_m, seed);
    const WorldVec v = mind.velocity(enemy, field.place_m, 0);
    quadrants.insert(2 * static_cast<int>(v.x() > 0.0) + static_cast<int>(v.y() > 0.0));
  }
  EXPECT_EQ(quadrants.size(), 4u);
}

TEST(Enemies, AlwaysMoveAtTheirSpeed) {
  Field field;
  field.terrain.obstacles = {{{12.0, 31.0}, 1.0}};
  for (const EnemyKind kind : {EnemyKind::Normal, EnemyKind::Decoy}) {
    EXPECT_NEAR(field.velocity(kind).norm(), field.config.enemies.speed_mps, 1e-12);
  }
}

TEST(Enemies, TurnAwayFromAnObstacleTooNear) {
  Field field;
  field.terrain.obstacles = {{{11.4, 30.0}, 1.0}};
  EXPECT_LT(field.velocity().x(), 0.0);
}

TEST(Enemies, TurnAwayFromAWallTooNear) {
  Field field;
  field.config.enemies.sight_blocked_by_walls = false;
  field.terrain.walls = {{{10.4, 0.0}, {10.4, 100.0}}};
  EXPECT_LT(field.velocity().x(), 0.0);
}

TEST(Enemies, DoNotMindAnObstacleOutOfReach) {
  Field field;
  field.terrain.obstacles = {{{10.0, 30.0 + 1.0 + field.config.enemies.avoid_reach_m}, 1.0}};
  EXPECT_TRUE(field.goes_straight());
}

TEST(Decoys, TurnBackWhenTheirTetherEnds) {
  const Field field;
  EnemyMind mind(field.config, field.terrain);
  const double tether = field.config.enemies.decoy_tether_m;
  Enemy enemy = an_enemy(EnemyKind::Decoy, field.place_m);
  const WorldVec strayed = field.place_m + (tether + 0.01) * WorldVec{0.6, 0.8};
  const WorldVec back = mind.velocity(enemy, strayed, 0);
  EXPECT_NEAR((back - field.config.enemies.speed_mps * WorldVec{-0.6, -0.8}).norm(), 0.0, 1e-9);
}

TEST(Decoys, StayWithinTheirTether) {
  const Field field;
  EnemyMind mind(field.config, field.terrain);
  const double step_m = field.config.enemies.speed_mps * field.config.physics.tick_s;
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    Enemy enemy = an_enemy(EnemyKind::Decoy, field.place_m, seed);
    WorldVec place = field.place_m;
    double farthest = 0.0;
    for (Tick tick = 0; tick < 5000; ++tick) {
      place += field.config.physics.tick_s * mind.velocity(enemy, place, tick);
      farthest = std::max(farthest, (place - enemy.appeared_m).norm());
    }
    EXPECT_LE(farthest, field.config.enemies.decoy_tether_m + step_m);
    EXPECT_GT(farthest, 0.5 * field.config.enemies.decoy_tether_m);
  }
}

}  // namespace
}  // namespace tacit
