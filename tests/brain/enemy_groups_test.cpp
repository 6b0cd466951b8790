#include "robot_agent/brain/perception/enemy_groups.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/brain/percepts.h"

namespace tacit {
namespace {

using testing::seen;

std::vector<EnemyGroup> groups_of(std::vector<Seen> enemies) {
  std::vector<EnemyGroup> groups;
  EnemyGroups(EnemyGroups::Config{.linking_distance_m = 15.0}).find(enemies, groups);
  std::sort(groups.begin(), groups.end(),
            [](const EnemyGroup& a, const EnemyGroup& b) { return nearer(a.nearest, b.nearest); });
  return groups;
}

TEST(EnemyGroups, AreNoneWithoutEnemies) { EXPECT_TRUE(groups_of({}).empty()); }

TEST(EnemyGroups, JoinEnemiesWithinLinkingDistance) {
  EXPECT_EQ(groups_of({seen(10, 0), seen(25, 0)}).size(), 1U);
  EXPECT_EQ(groups_of({seen(10, 0), seen(25.001, 0)}).size(), 2U);
}

TEST(EnemyGroups, JoinAlongAChain) {
  const auto groups = groups_of({seen(10, 0), seen(40, 0), seen(25, 0), seen(55, 0)});
  ASSERT_EQ(groups.size(), 1U);
  EXPECT_EQ(groups[0].size, 4U);
}

TEST(EnemyGroups, KnowTheirSizeCentroidAndNearestMember) {
  const auto groups = groups_of({seen(20, 3), seen(26, 3), seen(-50, 0), seen(23, -3)});
  ASSERT_EQ(groups.size(), 2U);
  EXPECT_EQ(groups[0].size, 3U);
  EXPECT_DOUBLE_EQ(groups[0].centroid_m.x(), 23.0);
  EXPECT_DOUBLE_EQ(groups[0].centroid_m.y(), 1.0);
  EXPECT_EQ(groups[0].nearest.offset_m, BodyVec(20, 3));
  EXPECT_EQ(groups[1].size, 1U);
}

// The law that defines a connected component, checked by repeated relaxation.
std::size_t components(const std::vector<Seen>& enemies, double link_m) {
  std::vector<std::size_t> label(enemies.size());
  for (std::size_t i = 0; i < label.size(); ++i) label[i] = i;
  for (std::size_t round = 0; round < enemies.size(); ++round) {
    for (std::size_t i = 0; i < enemies.size(); ++i) {
      for (std::size_t j = 0; j < enemies.size(); ++j) {
        if ((enemies[i].offset_m - enemies[j].offset_m).norm() <= link_m) {
          label[i] = label[j] = std::min(label[i], label[j]);
        }
      }
    }
  }
  std::sort(label.begin(), label.end());
  return static_cast<std::size_t>(std::unique(label.begin(), label.end()) - label.begin());
}

TEST(EnemyGroups, AreTheConnectedComponents) {
  Stream chance(3, "enemies");
  for (int trial = 0; trial < 100; ++trial) {
    std::vector<Seen> enemies;
    for (std::uint64_t n = chance.below(40); n > 0; --n) {
      enemies.push_back(seen(chance.uniform(-75, 75), chance.uniform(-75, 75)));
    }
    const auto groups = groups_of(enemies);
    std::size_t members = 0;
    for (const EnemyGroup& group : groups) members += group.size;
    ASSERT_EQ(groups.size(), components(enemies, 15.0));
    ASSERT_EQ(members, enemies.size());
  }
}

TEST(NearestGroup, IsTheOneWithTheNearestMemberNotTheNearestCentroid) {
  const auto groups = groups_of({seen(0, 20), seen(10, 0), seen(24, 0), seen(38, 0)});
  ASSERT_EQ(groups.size(), 2U);
  EXPECT_EQ(nearest_group(groups)->size, 3U);
}

TEST(NearestGroup, IsNullWithoutGroups) { EXPECT_EQ(nearest_group({}), nullptr); }

}  // namespace
}  // namespace tacit
