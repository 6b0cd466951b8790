#include "console/metrics/tally.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>

#include "idl/types/random.h"

namespace tacit {
namespace {

Happening random_happening(Stream& stream) {
  const auto kind = stream.below(2) == 0 ? EnemyKind::Normal : EnemyKind::Decoy;
  switch (stream.below(6)) {
    case 0:
      return EnemyCreated{EnemyId{1}, kind, {0.0, 0.0}};
    case 1:
      return EnemyIntercepted{EnemyId{1}, kind, RobotId{1}, stream.uniform(0.0, 100.0)};
    case 2:
      return TargetHit{EnemyId{1}, stream.uniform(0.0, 2.0)};
    case 3:
      return RobotLate{RobotId{1}};
    case 4:
      return Checkpoint{0, 0, stream.uniform(0.0, 50.0), stream.uniform(0.0, 2.0)};
    default:
      return Collision{};
  }
}

TEST(Tally, FeedsEveryFold) {
  Tally tally;
  tally.add({1, EnemyCreated{}});
  tally.add({2, EnemyCreated{EnemyId{2}, EnemyKind::Decoy, {}}});
  tally.add({3, EnemyIntercepted{EnemyId{1}, EnemyKind::Normal, RobotId{1}, 40.0}});
  tally.add({4, Collision{}});
  tally.add({5, RobotLost{}});
  tally.add({6, Checkpoint{0, 0, 12.0, 0.5}});
  tally.add({7, RunEnded{}});

  EXPECT_EQ(tally.value("created"), 1.0);
  EXPECT_EQ(tally.value("decoys_created"), 1.0);
  EXPECT_EQ(tally.value("mean_death_distance_m"), 40.0);
  EXPECT_EQ(tally.value("collisions"), 1.0);
  EXPECT_EQ(tally.value("robots_lost"), 1.0);
  EXPECT_EQ(tally.value("idle_mean_distance_m"), 12.0);
  EXPECT_EQ(tally.of<Length>().ticks, 7);
}

TEST(Tally, KeysAreUniqueAndExplained) {
  std::set<std::string_view> keys;
  for (const Metric& metric : Tally().metrics()) {
    EXPECT_TRUE(keys.insert(metric.key).second) << metric.key;
    EXPECT_TRUE(metric.doc.ends_with('.')) << metric.key;
  }
}

TEST(Tally, AnEmptyRunHasCountsButNoMeasures) {
  for (const Metric& metric : Tally().metrics()) {
    EXPECT_EQ(metric.value.has_value(), metric.unit.empty()) << metric.key;
  }
}

TEST(Tally, AnOperationHasNoMeasuresOfAGuard) {
  Tally tally;
  tally.add({0, OperationBegun{2, 1}});
  tally.add({1, Collision{}});
  EXPECT_EQ(tally.value("created"), std::nullopt);
  EXPECT_EQ(tally.value("idle_mean_distance_m"), std::nullopt);
  EXPECT_EQ(tally.value("collisions"), 1.0);
}

TEST(Tally, EveryDeathOfANormalEnemyHasADistance) {
  Stream stream(5, "tally");
  Tally tally;
  for (Tick tick = 1; tick < 1000; ++tick) {
    tally.add({tick, random_happening(stream)});
  }
  const auto& enemies = tally.of<Enemies>();
  EXPECT_EQ(enemies.intercepted + enemies.successful, tally.of<DeathDistance>().deaths);
}

TEST(Tally, CountsDoNotDependOnTheOrderOfEvents) {
  Stream stream(6, "tally");
  std::vector<Event> events;
  for (Tick tick = 1; tick < 300; ++tick) {
    events.push_back({tick, random_happening(stream)});
  }
  Tally forward;
  Tally backward;
  std::for_each(events.begin(), events.end(), [&](const Event& e) { forward.add(e); });
  std::for_each(events.rbegin(), events.rend(), [&](const Event& e) { backward.add(e); });

  for (const char* key : {"created", "intercepted", "successful", "decoys_created", "collisions",
                          "robots_late", "intercept_percent"}) {
    EXPECT_EQ(forward.value(key), backward.value(key)) << key;
  }
  EXPECT_NEAR(*forward.value("mean_death_distance_m"), *backward.value("mean_death_distance_m"),
              1e-9);
}

TEST(Tally, AnUnknownKeyHasNoValue) { EXPECT_EQ(Tally().value("altitude_m"), std::nullopt); }

}  // namespace
}  // namespace tacit
