#include "world_server/world/sensing/near_map.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "idl/types/random.h"

namespace tacit {
namespace {

Terrain random_terrain(Stream& chance) {
  Terrain terrain{chance.uniform(10.0, 200.0), chance.uniform(10.0, 200.0), false, {}, {}};
  const auto inside = [&] {
    return WorldVec{chance.uniform(0.0, terrain.width_m), chance.uniform(0.0, terrain.height_m)};
  };
  for (int i = 0; i < 40; ++i) {
    terrain.obstacles.push_back({inside(), chance.uniform(0.1, 5.0)});
    terrain.walls.push_back({inside(), inside()});
  }
  return terrain;
}

bool holds(std::span<const std::uint16_t> list, std::size_t index) {
  return std::find(list.begin(), list.end(), index) != list.end();
}

// Also from outside, where bodies get when the area has no border.
WorldVec anywhere(const Terrain& terrain, Stream& chance) {
  return {chance.uniform(-0.5 * terrain.width_m, 1.5 * terrain.width_m),
          chance.uniform(-0.5 * terrain.height_m, 1.5 * terrain.height_m)};
}

TEST(NearMap, MissesNoObstacleInReach) {
  Stream chance(1, "near");
  for (int round = 0; round < 20; ++round) {
    const Terrain terrain = random_terrain(chance);
    const double reach = chance.uniform(0.5, 30.0);
    const NearMap map(terrain, reach);
    for (int i = 0; i < 100; ++i) {
      const WorldVec p = anywhere(terrain, chance);
      const NearMap::Near near = map.near(p);
      for (std::size_t k = 0; k < terrain.obstacles.size(); ++k) {
        const Disc& disc = terrain.obstacles[k];
        const bool in_reach = (disc.centre_m - p).norm() - disc.radius_m <= reach;
        ASSERT_TRUE(!in_reach || holds(near.obstacles, k));
      }
    }
  }
}

TEST(NearMap, MissesNoWallInReach) {
  Stream chance(2, "near");
  for (int round = 0; round < 20; ++round) {
    const Terrain terrain = random_terrain(chance);
    const double reach = chance.uniform(0.5, 30.0);
    const NearMap map(terrain, reach);
    for (int i = 0; i < 100; ++i) {
      const WorldVec p = anywhere(terrain, chance);
      const NearMap::Near near = map.near(p);
      for (std::size_t k = 0; k < terrain.walls.size(); ++k) {
        const bool in_reach = (nearest_point(terrain.walls[k], p) - p).norm() <= reach;
        ASSERT_TRUE(!in_reach || holds(near.walls, k));
      }
    }
  }
}

TEST(NearMap, LeavesOutWhatIsFarOff) {
  Terrain terrain{200.0, 200.0, true, {{{10.0, 10.0}, 1.0}, {{190.0, 190.0}, 1.0}}, {}};
  const NearMap map(terrain, 5.0);
  const NearMap::Near near = map.near({12.0, 12.0});
  EXPECT_TRUE(holds(near.obstacles, 0));
  EXPECT_FALSE(holds(near.obstacles, 1));
}

TEST(NearMap, NamesEachThingOnceInOrder) {
  Stream chance(3, "near");
  const Terrain terrain = random_terrain(chance);
  const NearMap map(terrain, 20.0);
  for (int i = 0; i < 100; ++i) {
    const NearMap::Near near = map.near(anywhere(terrain, chance));
    ASSERT_TRUE(std::is_sorted(near.obstacles.begin(), near.obstacles.end()));
    ASSERT_EQ(std::adjacent_find(near.obstacles.begin(), near.obstacles.end()),
              near.obstacles.end());
  }
}

}  // namespace
}  // namespace tacit
