#include <gtest/gtest.h>

#include "robot_agent/brain/schemas/move_to.h"
#include "robot_agent/brain/schemas/pursue_enemy.h"
#include "tests/brain/forage_surroundings.h"

namespace tacit {
namespace {

using testing::enemy;
using testing::ForageEyes;
using testing::mine;
using testing::percept;

TEST(MoveTo, PullsWithStrengthOneTowardsTheNearest) {
  ForageEyes eyes;
  const BodyVec push = MoveTo(Thing::Mine).push(eyes.look({mine(30, 40), mine(300, 0)}));
  EXPECT_DOUBLE_EQ(push.x(), 0.6);
  EXPECT_DOUBLE_EQ(push.y(), 0.8);
}

TEST(MoveTo, IsSilentWhileNoneIsKnown) {
  ForageEyes eyes;
  EXPECT_EQ(MoveTo(Thing::Enemy).push(eyes.look({mine(30, 40)})), BodyVec());
}

TEST(MoveTo, IsSilentOnTheSpot) {
  ForageEyes eyes;
  EXPECT_EQ(MoveTo(Thing::Mine).push(eyes.look({mine(0, 0)})), BodyVec());
}

TEST(PursueEnemy, GoesStraightAtAnEnemyThatItHasNoTrackOf) {
  ForageEyes eyes;
  EXPECT_EQ(PursueEnemy().push(eyes.look({enemy(0, 7)})), BodyVec(0, 1));
}

TEST(PursueEnemy, IsSilentWithoutAnEnemyAndOnTheSpot) {
  ForageEyes eyes;
  EXPECT_EQ(PursueEnemy().push(eyes.look({mine(0, 7)})), BodyVec());
  EXPECT_EQ(PursueEnemy().push(eyes.look({enemy(0, 0)})), BodyVec());
}

TEST(PursueEnemy, LeadsAnEnemyThatCrosses) {
  ForageEyes eyes;
  // The robot moves 0.5 m ahead in a tick, the enemy 0.3 m to the left.
  eyes.look({enemy(10, 0)});
  Percept next = percept(0, {enemy(9.5, 0.3)});
  next.odometry.position_m = {0.5, 0.0};
  const BodyVec push = PursueEnemy().push(eyes.look(next));
  EXPECT_NEAR(push.norm(), 1.0, 1e-12);
  // Across the line of sight both are equally fast: 0.3 = 0.5 * sine, but for the little angle
  // that the enemy has already moved through.
  const BodyVec towards = unit(BodyVec(9.5, 0.3));
  EXPECT_NEAR(0.5 * towards.cross(push), towards.cross({0.0, 0.3}), 1e-12);
}

TEST(PursueEnemy, GoesStraightAtAnEnemyThatItCannotMeet) {
  ForageEyes eyes;
  eyes.look({enemy(10, 0)});
  EXPECT_EQ(PursueEnemy().push(eyes.look({enemy(10.4, 0)})), BodyVec(1, 0));
}

}  // namespace
}  // namespace tacit
