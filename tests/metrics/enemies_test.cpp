#include "console/metrics/enemies.h"

#include <gtest/gtest.h>

#include "console/metrics/improvement.h"

namespace tacit {
namespace {

template <class Fold>
Fold folded(std::initializer_list<Happening> happenings) {
  Fold fold;
  for (const Happening& what : happenings) {
    fold.add({1, what});
  }
  return fold;
}

EnemyCreated created(EnemyKind kind) { return {EnemyId{1}, kind, {0.0, 0.0}}; }
EnemyIntercepted intercepted(EnemyKind kind, double distance_m) {
  return {EnemyId{1}, kind, RobotId{1}, distance_m};
}
TargetHit hit(double distance_m) { return {EnemyId{1}, distance_m}; }

TEST(Enemies, CountNormalEnemiesByFate) {
  const auto enemies = folded<Enemies>(
      {created(EnemyKind::Normal), created(EnemyKind::Normal), created(EnemyKind::Normal),
       intercepted(EnemyKind::Normal, 10.0), intercepted(EnemyKind::Normal, 10.0), hit(2.0)});

  EXPECT_EQ(enemies.created, 3);
  EXPECT_EQ(enemies.intercepted, 2);
  EXPECT_EQ(enemies.successful, 1);
}

TEST(Enemies, LeaveDecoysOut) {
  const auto enemies =
      folded<Enemies>({created(EnemyKind::Decoy), intercepted(EnemyKind::Decoy, 10.0)});

  EXPECT_EQ(enemies.created, 0);
  EXPECT_EQ(enemies.intercepted, 0);
}

TEST(Enemies, InterceptPercentLeavesOutThoseStillAlive) {
  const auto enemies = folded<Enemies>(
      {created(EnemyKind::Normal), intercepted(EnemyKind::Normal, 1.0),
       intercepted(EnemyKind::Normal, 1.0), intercepted(EnemyKind::Normal, 1.0), hit(1.0)});

  EXPECT_EQ(enemies.intercept_percent(), 75.0);
}

TEST(Enemies, InterceptPercentIsAbsentWhileNoFateIsKnown) {
  EXPECT_EQ(folded<Enemies>({created(EnemyKind::Normal)}).intercept_percent(), std::nullopt);
}

TEST(DeathDistance, CountsASuccessAtTheDistanceOfItsHit) {
  const auto distance = folded<DeathDistance>({intercepted(EnemyKind::Normal, 40.0), hit(2.0)});

  EXPECT_EQ(distance.mean_m(), 21.0);
}

TEST(DeathDistance, LeavesDecoysOut) {
  const auto distance = folded<DeathDistance>(
      {intercepted(EnemyKind::Normal, 40.0), intercepted(EnemyKind::Decoy, 90.0)});

  EXPECT_EQ(distance.mean_m(), 40.0);
}

TEST(DeathDistance, IsAbsentWhenNothingDied) {
  EXPECT_EQ(folded<DeathDistance>({created(EnemyKind::Normal)}).mean_m(), std::nullopt);
}

TEST(Decoys, AreCountedApart) {
  const auto decoys = folded<Decoys>(
      {created(EnemyKind::Decoy), created(EnemyKind::Decoy), created(EnemyKind::Normal),
       intercepted(EnemyKind::Decoy, 1.0), intercepted(EnemyKind::Normal, 1.0)});

  EXPECT_EQ(decoys.created, 2);
  EXPECT_EQ(decoys.intercepted, 1);
}

TEST(ImprovementRatio, IsOneForATeamThatIsTheSumOfItsRobots) {
  EXPECT_EQ(improvement_ratio(60.0, 6, 10.0), 1.0);
}

TEST(ImprovementRatio, IsBelowOneForASublinearTeam) {
  EXPECT_EQ(improvement_ratio(30.0, 3, 20.0), 0.5);
}

TEST(ImprovementRatio, IsAbsentWithoutASingleRobotToCompareWith) {
  EXPECT_EQ(improvement_ratio(30.0, 3, std::nullopt), std::nullopt);
  EXPECT_EQ(improvement_ratio(30.0, 3, 0.0), std::nullopt);
  EXPECT_EQ(improvement_ratio(30.0, 0, 1.0), std::nullopt);
  EXPECT_EQ(improvement_ratio(std::nullopt, 3, 1.0), std::nullopt);
}

}  // namespace
}  // namespace tacit
