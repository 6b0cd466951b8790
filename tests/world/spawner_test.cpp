#include "world_server/world/enemies/spawner.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <set>
#include <utility>
#include <vector>

#include "tests/world/sample_worlds.h"

namespace tacit {
namespace {

WorldConfig attacked(std::int64_t strategy) {
  WorldConfig config;
  config.obstacles.coverage_percent = 0.0;
  config.enemies.strategy = strategy;
  return config;
}

struct Arrived {
  Tick tick = 0;
  Arrival arrival;
};

// All arrivals of a run in which every enemy dies at once.
std::vector<Arrived> arrived(const WorldConfig& config, Tick ticks, std::uint64_t seed = 1) {
  const Terrain terrain = make_terrain(config, seed);
  Spawner spawner(config, terrain, seed);
  const std::vector<std::int64_t> nobody(spawner.waves(), 0);
  std::vector<Arrived> all;
  for (Tick tick = 0; tick < ticks; ++tick) {
    for (const Arrival& arrival : spawner.arrivals(tick, nobody)) {
      all.push_back({tick, arrival});
    }
  }
  return all;
}

double direction_deg(const WorldConfig& config, const WorldVec& place) {
  const WorldVec offset = place - WorldVec{config.target.x_m, config.target.y_m};
  const double degrees = arc_tangent(offset.y(), offset.x()) * 180.0 / kPi;
  return degrees < 0.0 ? degrees + 360.0 : degrees;
}

// The sides an attack comes from, in degrees from the east, to the nearest 45.
std::set<int> sides(std::int64_t strategy, EnemyKind kind) {
  const WorldConfig config = attacked(strategy);
  std::set<int> found;
  for (const Arrived& a : arrived(config, 3000)) {
    if (a.arrival.kind == kind) {
      found.insert(
          static_cast<int>(std::lround(direction_deg(config, a.arrival.position_m) / 45.0)) % 8 *
          45);
    }
  }
  return found;
}

TEST(FirstStrategy, ComesFromAllFourSides) {
  EXPECT_EQ(sides(1, EnemyKind::Normal), (std::set<int>{0, 90, 180, 270}));
  EXPECT_TRUE(sides(1, EnemyKind::Decoy).empty());
}

TEST(SecondStrategy, ComesFromTheWesternSides) {
  EXPECT_EQ(sides(2, EnemyKind::Normal), (std::set<int>{135, 180, 225}));
  EXPECT_TRUE(sides(2, EnemyKind::Decoy).empty());
}

TEST(ThirdStrategy, ComesFromTheNorthEastWithDecoysInTheWest) {
  EXPECT_EQ(sides(3, EnemyKind::Normal), (std::set<int>{45}));
  EXPECT_EQ(sides(3, EnemyKind::Decoy), (std::set<int>{180}));
}

TEST(FourthStrategy, ComesFromTheNorthEastWithDecoysInTheWestAndSouth) {
  EXPECT_EQ(sides(4, EnemyKind::Normal), (std::set<int>{45}));
  EXPECT_EQ(sides(4, EnemyKind::Decoy), (std::set<int>{180, 270}));
}

TEST(FifthStrategy, ComesFromEverywhere) {
  EXPECT_EQ(sides(5, EnemyKind::Normal).size(), 8u);
  EXPECT_TRUE(sides(5, EnemyKind::Decoy).empty());
}

TEST(FifthStrategy, ComesInPairsFromExactlyOppositeSides) {
  WorldConfig config = attacked(5);
  config.enemies.spawn_jitter_m = 0.0;
  const std::vector<Arrived> all = arrived(config, 3000);
  ASSERT_GT(all.size(), 20u);
  ASSERT_EQ(all.size() % 2, 0u);
  for (std::size_t i = 0; i < all.size(); i += 2) {
    ASSERT_EQ(all[i].tick, all[i + 1].tick);
    const double first = direction_deg(config, all[i].arrival.position_m);
    const double second = direction_deg(config, all[i + 1].arrival.position_m);
    ASSERT_NEAR(std::abs(first - second), 180.0, 1e-9);
  }
}

TEST(NoStrategy, HasNoEnemies) { EXPECT_TRUE(arrived(attacked(0), 3000).empty()); }

TEST(Strategies, ThreeAndFourSendGroupsOfFive) {
  for (const std::int64_t strategy : {3, 4}) {
    std::map<Tick, int> at;
    for (const Arrived& a : arrived(attacked(strategy), 3000)) {
      at[a.tick] += static_cast<int>(a.arrival.kind == EnemyKind::Normal);
    }
    std::erase_if(at, [](const auto& entry) { return entry.second == 0; });
    ASSERT_GT(at.size(), 5u);
    for (const auto& [tick, count] : at) {
      EXPECT_EQ(count, 5) << tick;
    }
  }
}

TEST(Strategies, OneAndTwoSendOneEnemyPerSideAtATime) {
  for (const std::int64_t strategy : {1, 2}) {
    std::set<std::pair<Tick, std::size_t>> seen;
    for (const Arrived& a : arrived(attacked(strategy), 3000)) {
      EXPECT_TRUE(seen.insert({a.tick, a.arrival.wave}).second);
    }
  }
}

TEST(Strategies, KeepTheirPeriods) {
  for (std::int64_t strategy = 1; strategy <= 5; ++strategy) {
    WorldConfig config = attacked(strategy);
    config.enemies.period_scale = 1.5;
    std::map<std::size_t, std::set<Tick>> at;
    for (const Arrived& a : arrived(config, 2000)) {
      at[a.arrival.wave].insert(a.tick);
    }
    const auto waves = strategy_waves(strategy);
    ASSERT_EQ(at.size(), waves.size());
    for (const auto& [wave, ticks] : at) {
      const double period = waves[wave].period_s * 1.5 / config.physics.tick_s;
      Tick expected = 0;
      for (const Tick tick : ticks) {
        ASSERT_EQ(tick, expected);
        expected += static_cast<Tick>(std::lround(period));
      }
    }
  }
}

TEST(Decoys, AreToppedUpToTheirNumber) {
  const WorldConfig config = attacked(3);
  const Terrain terrain = make_terrain(config, 1);
  const std::int64_t keep = strategy_waves(3)[1].keep;
  ASSERT_GE(keep, 1);
  for (std::int64_t alive = 0; alive <= keep + 1; ++alive) {
    Spawner spawner(config, terrain, 1);
    const auto arrivals = spawner.arrivals(0, std::vector<std::int64_t>{0, alive});
    const auto decoys = std::count_if(arrivals.begin(), arrivals.end(),
                                      [](const Arrival& a) { return a.kind == EnemyKind::Decoy; });
    EXPECT_EQ(decoys, std::max<std::int64_t>(0, keep - alive)) << alive;
  }
}

TEST(Spawner, NeverMakesMoreThanTheLimit) {
  for (std::int64_t strategy = 1; strategy <= 5; ++strategy) {
    for (std::int64_t limit = 0; limit <= 9; ++limit) {
      WorldConfig config = attacked(strategy);
      config.enemies.max_alive = limit;
      const Terrain terrain = make_terrain(config, 1);
      Spawner spawner(config, terrain, 1);
      std::vector<std::int64_t> alive(spawner.waves(), 0);
      for (Tick tick = 0; tick < 1000; ++tick) {
        for (const Arrival& arrival : spawner.arrivals(tick, alive)) {
          ++alive[arrival.wave];
        }
      }
      EXPECT_LE(std::accumulate(alive.begin(), alive.end(), std::int64_t{0}), limit) << strategy;
    }
  }
}

TEST(Spawner, PlacesEnemiesOnTheRim) {
  for (std::int64_t strategy = 1; strategy <= 5; ++strategy) {
    const WorldConfig config = attacked(strategy);
    const double inset = 2.0 * config.enemies.radius_m;
    for (const Arrived& a : arrived(config, 2000)) {
      const WorldVec p = a.arrival.position_m;
      const double to_rim =
          std::min({p.x(), p.y(), config.area.width_m - p.x(), config.area.height_m - p.y()});
      ASSERT_NEAR(to_rim, inset, 1e-9);
    }
  }
}

TEST(Spawner, ShiftsPlacesAlongTheRimByNoMoreThanTheJitter) {
  const WorldConfig config = attacked(1);
  double widest = 0.0;
  for (const Arrived& a : arrived(config, 10000)) {
    if (strategy_waves(1)[a.arrival.wave].from_deg == 180.0) {
      widest = std::max(widest, std::abs(a.arrival.position_m.y() - config.target.y_m));
    }
  }
  EXPECT_LE(widest, config.enemies.spawn_jitter_m);
  EXPECT_GT(widest, 0.5 * config.enemies.spawn_jitter_m);
}

TEST(Spawner, PlacesNoEnemyInAnObstacleOrInAnother) {
  WorldConfig config = attacked(3);
  config.enemies.spawn_jitter_m = 1.0;
  config.obstacles.discs = {{199.0, 199.0, 4.0}, {2.0, 100.0, 3.0}};
  std::vector<Arrived> same_tick;
  for (const Arrived& a : arrived(config, 2000)) {
    for (const auto& disc : config.obstacles.discs) {
      const double gap = (WorldVec{disc[0], disc[1]} - a.arrival.position_m).norm() - disc[2];
      ASSERT_GE(gap, config.enemies.radius_m - 1e-9);
    }
    std::erase_if(same_tick, [&a](const Arrived& old) { return old.tick != a.tick; });
    for (const Arrived& other : same_tick) {
      ASSERT_GE((other.arrival.position_m - a.arrival.position_m).norm(),
                2.0 * config.enemies.radius_m - 1e-9);
    }
    same_tick.push_back(a);
  }
}

TEST(Spawner, DrawsOtherPlacesForAnotherSeed) {
  EXPECT_FALSE(arrived(attacked(1), 1, 1)[0].arrival.position_m ==
               arrived(attacked(1), 1, 2)[0].arrival.position_m);
}

}  // namespace
}  // namespace tacit
