#include "world_server/world/physics.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "idl/types/random.h"

namespace tacit {
namespace {

// What the guard scenario has: radius, tick, and the fastest that two bodies close on each other.
constexpr double kRadius_m = 0.2;
constexpr double kTick_s = 0.1;
constexpr double kSpeed_mps = 2.0;

Terrain open_area() { return {100.0, 100.0, false, {}, {}}; }

TEST(Physics, MovesABodyByItsVelocityTimesTheDuration) {
  Physics physics(open_area());
  const BodySlot body = physics.add({10.0, 20.0}, kRadius_m);
  physics.set_velocity(body, {1.5, -0.5});
  for (int i = 0; i < 100; ++i) {
    physics.step(kTick_s);
  }
  EXPECT_NEAR(physics.position(body).x(), 25.0, 1e-9);
  EXPECT_NEAR(physics.position(body).y(), 15.0, 1e-9);
}

TEST(Physics, KeepsAFreeBodysVelocity) {
  Physics physics(open_area());
  const BodySlot body = physics.add({10.0, 20.0}, kRadius_m);
  physics.set_velocity(body, {1.5, -0.5});
  for (int i = 0; i < 1000; ++i) {
    physics.step(0.01);
  }
  EXPECT_EQ(physics.velocity(body), (WorldVec{1.5, -0.5}));
}

TEST(Physics, NeverPutsABodyToSleep) {
  Physics physics(open_area());
  const BodySlot body = physics.add({10.0, 20.0}, kRadius_m);
  for (int i = 0; i < 200; ++i) {
    physics.step(kTick_s);
  }
  physics.set_velocity(body, {1.0, 0.0});
  physics.step(kTick_s);
  EXPECT_NEAR(physics.position(body).x(), 10.1, 1e-12);
}

TEST(Physics, LetsNoBodyThroughAnother) {
  for (double gap_m = 0.5; gap_m < 1.0; gap_m += 0.01) {
    Physics physics(open_area());
    const BodySlot left = physics.add({10.0, 10.0}, kRadius_m);
    const BodySlot right = physics.add({10.0 + gap_m, 10.0}, kRadius_m);
    for (int i = 0; i < 30; ++i) {
      physics.set_velocity(left, {kSpeed_mps, 0.0});
      physics.set_velocity(right, {-kSpeed_mps, 0.0});
      physics.step(kTick_s);
      ASSERT_LT(physics.position(left).x(), physics.position(right).x()) << gap_m;
    }
  }
}

TEST(Physics, PartsBodiesThatOverlap) {
  Physics physics(open_area());
  const BodySlot left = physics.add({10.0, 10.0}, kRadius_m);
  const BodySlot right = physics.add({10.1, 10.0}, kRadius_m);
  for (int i = 0; i < 30; ++i) {
    physics.set_velocity(left, {});
    physics.set_velocity(right, {});
    physics.step(kTick_s);
  }
  const WorldVec apart = physics.position(right) - physics.position(left);
  EXPECT_NEAR(apart.x(), 2.0 * kRadius_m, 0.05);
}

TEST(Physics, LetsNoBodyThroughAnObstacle) {
  Terrain terrain = open_area();
  terrain.obstacles = {{{20.0, 10.0}, 1.0}};
  Physics physics(terrain);
  const BodySlot body = physics.add({15.0, 10.0}, kRadius_m);
  for (int i = 0; i < 100; ++i) {
    physics.set_velocity(body, {kSpeed_mps, 0.0});
    physics.step(kTick_s);
  }
  EXPECT_NEAR(physics.position(body).x(), 20.0 - 1.0 - kRadius_m, 0.1);
}

TEST(Physics, LetsNoBodyThroughAWall) {
  Terrain terrain = open_area();
  terrain.walls = {{{5.0, 5.0}, {25.0, 25.0}}};
  Physics physics(terrain);
  const BodySlot body = physics.add({18.0, 12.0}, kRadius_m);
  for (int i = 0; i < 100; ++i) {
    physics.set_velocity(body, unit(WorldVec{-1.0, 1.0}));
    physics.step(kTick_s);
    ASSERT_GT(physics.position(body).x(), physics.position(body).y());
  }
}

TEST(Physics, LetsNoBodyOutOfTheBorder) {
  Terrain terrain{20.0, 10.0, true, {}, {}};
  for (const WorldVec& way : {WorldVec{1, 0}, WorldVec{-1, 0}, WorldVec{0, 1}, WorldVec{0, -1}}) {
    Physics physics(terrain);
    const BodySlot body = physics.add({10.0, 5.0}, kRadius_m);
    for (int i = 0; i < 200; ++i) {
      physics.set_velocity(body, kSpeed_mps * way);
      physics.step(kTick_s);
    }
    const WorldVec place = physics.position(body);
    EXPECT_GT(std::min({place.x(), place.y(), 20.0 - place.x(), 10.0 - place.y()}), 0.0);
  }
}

TEST(Physics, LetsABodyLeaveAnAreaWithoutABorder) {
  Physics physics(open_area());
  const BodySlot body = physics.add({1.0, 50.0}, kRadius_m);
  physics.set_velocity(body, {-kSpeed_mps, 0.0});
  for (int i = 0; i < 20; ++i) {
    physics.step(kTick_s);
  }
  EXPECT_NEAR(physics.position(body).x(), -3.0, 1e-9);
}

TEST(Physics, LetsABodySlideAlongAWallWithoutFriction) {
  Terrain terrain = open_area();
  terrain.walls = {{{0.0, 10.0}, {100.0, 10.0}}};
  Physics physics(terrain);
  const BodySlot body = physics.add({20.0, 10.0 + kRadius_m + 0.05}, kRadius_m);
  for (int i = 0; i < 100; ++i) {
    physics.set_velocity(body, {1.0, -1.0});
    physics.step(kTick_s);
  }
  EXPECT_NEAR(physics.position(body).x(), 30.0, 0.05);
}

TEST(Physics, UsesTheSlotOfARemovedBodyAgain) {
  Physics physics(open_area());
  const BodySlot first = physics.add({10.0, 10.0}, kRadius_m);
  const BodySlot second = physics.add({20.0, 10.0}, kRadius_m);
  physics.remove(first);
  EXPECT_EQ(physics.add({30.0, 10.0}, kRadius_m), first);
  EXPECT_EQ(physics.position(first), (WorldVec{30.0, 10.0}));
  EXPECT_EQ(physics.position(second), (WorldVec{20.0, 10.0}));
}

TEST(Physics, GivesAReusedSlotNothingOfItsFormerBody) {
  Physics physics(open_area());
  const BodySlot first = physics.add({10.0, 10.0}, kRadius_m);
  physics.set_velocity(first, {1.0, 1.0});
  physics.step(kTick_s);
  physics.remove(first);
  const BodySlot again = physics.add({30.0, 10.0}, kRadius_m);
  physics.step(kTick_s);
  EXPECT_EQ(physics.position(again), (WorldVec{30.0, 10.0}));
  EXPECT_EQ(physics.velocity(again), WorldVec{});
}

TEST(Physics, LeavesOthersAloneWhateverTheOrderOfRemoval) {
  Physics physics(open_area());
  std::vector<BodySlot> bodies;
  for (int i = 0; i < 10; ++i) {
    bodies.push_back(physics.add({5.0 + 5.0 * i, 50.0}, kRadius_m));
    physics.set_velocity(bodies.back(), {0.0, 0.1 * i});
  }
  for (const int gone : {9, 0, 5, 4, 1}) {
    physics.remove(bodies[static_cast<std::size_t>(gone)]);
    physics.step(kTick_s);
  }
  for (const int left : {2, 3, 6, 7, 8}) {
    const WorldVec place = physics.position(bodies[static_cast<std::size_t>(left)]);
    EXPECT_NEAR(place.x(), 5.0 + 5.0 * left, 1e-12);
    EXPECT_NEAR(place.y(), 50.0 + 0.05 * left, 1e-12);
  }
}

TEST(Physics, TellsWhatEachBodyTouches) {
  Terrain terrain = open_area();
  terrain.obstacles = {{{80.0, 80.0}, 1.0}, {{20.0, 11.1}, 1.0}};
  terrain.walls = {{{30.0, 0.0}, {30.0, 50.0}}};
  Physics physics(terrain);
  const BodySlot at_obstacle = physics.add({20.0, 10.0}, kRadius_m);
  const BodySlot at_wall = physics.add({30.2, 10.0}, kRadius_m);
  const BodySlot at_body = physics.add({30.55, 10.0}, kRadius_m);
  physics.step(kTick_s);
  const std::vector<Contact> expected{{at_obstacle, ContactSide::Obstacle, 1},
                                      {at_wall, ContactSide::Mover, at_body},
                                      {at_wall, ContactSide::Wall, 0}};
  const std::vector<Contact> got(physics.contacts().begin(), physics.contacts().end());
  EXPECT_EQ(got, expected);
}

TEST(Physics, NumbersTheBorderAfterTheWalls) {
  Terrain terrain{20.0, 20.0, true, {}, {{{5.0, 5.0}, {6.0, 5.0}}}};
  Physics physics(terrain);
  static_cast<void>(physics.add({0.19, 10.0}, kRadius_m));
  physics.step(kTick_s);
  ASSERT_EQ(physics.contacts().size(), 1u);
  EXPECT_EQ(physics.contacts()[0].with, ContactSide::Wall);
  EXPECT_EQ(physics.contacts()[0].other, 3u);
}

TEST(Physics, TellsNoContactOfBodiesApart) {
  Physics physics(open_area());
  static_cast<void>(physics.add({10.0, 10.0}, kRadius_m));
  static_cast<void>(physics.add({10.5, 10.0}, kRadius_m));
  physics.step(kTick_s);
  EXPECT_TRUE(physics.contacts().empty());
}

TEST(Physics, TellsContactsInOrderAndEachOnce) {
  Physics physics(open_area());
  Stream chance(1, "crowd");
  std::vector<BodySlot> bodies;
  for (int i = 0; i < 60; ++i) {
    bodies.push_back(physics.add({chance.uniform(48, 52), chance.uniform(48, 52)}, kRadius_m));
  }
  for (int tick = 0; tick < 30; ++tick) {
    for (const BodySlot body : bodies) {
      physics.set_velocity(body, unit(WorldVec{50.0, 50.0} - physics.position(body)));
    }
    physics.step(kTick_s);
    const auto contacts = physics.contacts();
    ASSERT_FALSE(contacts.empty());
    ASSERT_TRUE(std::is_sorted(contacts.begin(), contacts.end()));
    ASSERT_EQ(std::adjacent_find(contacts.begin(), contacts.end()), contacts.end());
    for (const Contact& contact : contacts) {
      ASSERT_LT(contact.mover, contact.other);
    }
  }
}

TEST(Physics, TellsAContactOfAnySubstep) {
  Terrain terrain = open_area();
  terrain.obstacles = {{{20.0, 10.0}, 1.0}};
  Physics physics(terrain);
  const BodySlot body = physics.add({18.75, 10.0}, kRadius_m);
  // One command, as in a tick of the world: pressed in the first parts, at rest in the last.
  physics.set_velocity(body, {kSpeed_mps, 0.0});
  physics.step(kTick_s, 10);
  EXPECT_EQ(physics.contacts().size(), 1u);
}

TEST(Physics, MovesAsFarInManySubstepsAsInOne) {
  Physics physics(open_area());
  const BodySlot body = physics.add({10.0, 20.0}, kRadius_m);
  physics.set_velocity(body, {1.5, -0.5});
  physics.step(kTick_s, 7);
  EXPECT_NEAR(physics.position(body).x(), 10.15, 1e-12);
  EXPECT_NEAR(physics.position(body).y(), 19.95, 1e-12);
}

TEST(Physics, ForgetsTheContactsOfARemovedBody) {
  Physics physics(open_area());
  static_cast<void>(physics.add({10.0, 10.0}, kRadius_m));
  const BodySlot other = physics.add({10.35, 10.0}, kRadius_m);
  physics.step(kTick_s);
  ASSERT_EQ(physics.contacts().size(), 1u);
  physics.remove(other);
  physics.step(kTick_s);
  EXPECT_TRUE(physics.contacts().empty());
}

TEST(Physics, KeepsWorkingWhenMoved) {
  Physics first(open_area());
  const BodySlot body = first.add({10.0, 10.0}, kRadius_m);
  first.set_velocity(body, {1.0, 0.0});
  Physics second = std::move(first);
  second.step(kTick_s);
  EXPECT_NEAR(second.position(body).x(), 10.1, 1e-12);
}

}  // namespace
}  // namespace tacit
