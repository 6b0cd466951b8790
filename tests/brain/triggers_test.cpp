#include <gtest/gtest.h>

#include "robot_agent/brain/triggers/registry.h"
#include "tests/brain/forage_surroundings.h"

namespace tacit {
namespace {

using testing::enemy;
using testing::ForageEyes;
using testing::holding;
using testing::mine;
using testing::percept;

bool fires(Trigger trigger, const Percept& percept) {
  ForageEyes eyes;
  return holds(trigger, eyes.look(percept));
}

TEST(Triggers, DetectFiresWhileAThingOfItsClassIsKnown) {
  EXPECT_TRUE(fires(Detect{Thing::Mine}, percept(0, {mine(40, 0)})));
  EXPECT_FALSE(fires(Detect{Thing::Mine}, percept(0, {enemy(1, 0)})));
}

TEST(Triggers, NotDetectedFiresWhileNoneIs) {
  EXPECT_FALSE(fires(NotDetected{Thing::Mine}, percept(0, {mine(40, 0)})));
  EXPECT_TRUE(fires(NotDetected{Thing::Mine}, percept(0, {enemy(1, 0)})));
}

TEST(Triggers, NearFiresUpToItsRange) {
  EXPECT_TRUE(fires(Near{Thing::Mine, 0.5}, percept(0, {mine(0.5, 0)})));
  EXPECT_FALSE(fires(Near{Thing::Mine, 0.5}, percept(0, {mine(0.51, 0), enemy(0.1, 0)})));
}

TEST(Triggers, AwayFromFiresBeyondItsRangeAndWhenNoneIsKnown) {
  EXPECT_FALSE(fires(AwayFrom{Thing::Mine, 0.5}, percept(0, {mine(0.5, 0)})));
  EXPECT_TRUE(fires(AwayFrom{Thing::Mine, 0.5}, percept(0, {mine(0.51, 0), enemy(0.1, 0)})));
  EXPECT_TRUE(fires(AwayFrom{Thing::Mine, 0.5}, percept(0, {})));
}

TEST(Triggers, HoldingFiresWhileTheRobotCarriesAMine) {
  EXPECT_TRUE(fires(Holding{}, holding({})));
  EXPECT_FALSE(fires(Holding{}, percept(0, {})));
}

TEST(Triggers, NotHoldingFiresWhileItCarriesNone) {
  EXPECT_FALSE(fires(NotHolding{}, holding({})));
  EXPECT_TRUE(fires(NotHolding{}, percept(0, {})));
}

TEST(Triggers, ImmediateAlwaysFires) { EXPECT_TRUE(fires(Immediate{}, percept(0, {}))); }

TEST(Triggers, WaitFiresSoManyTicksAfterItsStateWasEntered) {
  Trigger wait = Wait{3};
  notify_entered(wait, {100, {}});
  Surroundings around;
  around.tick = 102;
  EXPECT_FALSE(holds(wait, around));
  around.tick = 103;
  EXPECT_TRUE(holds(wait, around));
}

}  // namespace
}  // namespace tacit
