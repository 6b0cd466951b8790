#include "robot_agent/brain/assemblage/actuator.h"

#include <gtest/gtest.h>

namespace tacit {
namespace {

Actuator actuator() {
  return Actuator({.base_mps = 0.5,
                   .max_mps = 2.0,
                   .max_turn_radps = 3.0,
                   .turn_gain_per_s = 2.0,
                   .turn_from_mps = 0.05});
}

TEST(Actuator, ScalesTheSumByTheBaseSpeed) {
  EXPECT_EQ(actuator().velocity_mps({1.0, -2.0}), BodyVec(0.5, -1.0));
}

TEST(Actuator, ClipsToTheTopSpeedAndKeepsTheDirection) {
  const BodyVec velocity = actuator().velocity_mps({30.0, 40.0});
  EXPECT_NEAR(velocity.x(), 1.2, 1e-12);
  EXPECT_NEAR(velocity.y(), 1.6, 1e-12);
}

TEST(Actuator, TurnsTowardsTheMotionInProportion) {
  EXPECT_NEAR(actuator().turn_radps({1.0, 1.0}), 2.0 * kPi / 4.0, 1e-12);
  EXPECT_NEAR(actuator().turn_radps({1.0, -1.0}), -2.0 * kPi / 4.0, 1e-12);
  EXPECT_EQ(actuator().turn_radps({1.0, 0.0}), 0.0);
}

TEST(Actuator, LimitsTheTurn) {
  EXPECT_EQ(actuator().turn_radps({-1.0, 0.1}), 3.0);
  EXPECT_EQ(actuator().turn_radps({-1.0, -0.1}), -3.0);
}

TEST(Actuator, DoesNotTurnAtRest) {
  EXPECT_EQ(actuator().turn_radps({0.0, 0.049}), 0.0);
  EXPECT_GT(actuator().turn_radps({0.0, 0.051}), 0.0);
}

}  // namespace
}  // namespace tacit
