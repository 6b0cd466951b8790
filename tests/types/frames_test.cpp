#include "idl/types/frames.h"

#include <gtest/gtest.h>

#include <type_traits>

#include "idl/types/random.h"

namespace tacit {
namespace {

constexpr int kDraws = 2000;

WorldVec any_vector(Stream& chance) {
  return {chance.uniform(-100.0, 100.0), chance.uniform(-100.0, 100.0)};
}

Heading any_heading(Stream& chance) { return Heading::from_rad(chance.uniform(-kPi, kPi)); }

template <class A, class B>
concept Mix = requires(A a, B b) {
  a + b;
};

static_assert(Mix<WorldVec, WorldVec>);
static_assert(!Mix<WorldVec, BodyVec>, "vectors of two frames must not add");
static_assert(!std::is_convertible_v<WorldVec, OdometryVec>);

TEST(Frames, AreTheSameAfterGoingIntoTheBodyAndBack) {
  Stream chance(1, "frames");
  for (int i = 0; i < kDraws; ++i) {
    const Heading heading = any_heading(chance);
    const WorldVec v = any_vector(chance);
    const WorldVec back = from_body<WorldFrame>(heading, to_body(heading, v));
    ASSERT_NEAR((back - v).norm(), 0.0, 1e-13);
  }
}

TEST(Frames, AreTheSameAfterGoingOutOfTheBodyAndBack) {
  Stream chance(2, "frames");
  for (int i = 0; i < kDraws; ++i) {
    const Heading heading = any_heading(chance);
    const BodyVec v{any_vector(chance).xy};
    const BodyVec back = to_body(heading, from_body<WorldFrame>(heading, v));
    ASSERT_NEAR((back - v).norm(), 0.0, 1e-13);
  }
}

TEST(Frames, KeepLengthsWhenTurned) {
  Stream chance(3, "frames");
  for (int i = 0; i < kDraws; ++i) {
    const WorldVec v = any_vector(chance);
    ASSERT_NEAR(to_body(any_heading(chance), v).norm(), v.norm(), 1e-13);
  }
}

TEST(Frames, PutWhatLiesAheadOnTheBodysFirstAxis) {
  const Heading north = Heading::from_rad(kPi / 2);
  const BodyVec ahead = to_body(north, WorldVec{0.0, 3.0});
  EXPECT_NEAR(ahead.x(), 3.0, 1e-15);
  EXPECT_NEAR(ahead.y(), 0.0, 1e-15);
}

TEST(Frames, PutWhatLiesToTheLeftOnTheBodysSecondAxis) {
  const Heading north = Heading::from_rad(kPi / 2);
  const BodyVec left = to_body(north, WorldVec{-3.0, 0.0});
  EXPECT_NEAR(left.x(), 0.0, 1e-15);
  EXPECT_NEAR(left.y(), 3.0, 1e-15);
}

TEST(Headings, AddWhenTurned) {
  Stream chance(4, "frames");
  for (int i = 0; i < kDraws; ++i) {
    const double first = chance.uniform(-kPi, kPi);
    const double second = chance.uniform(-kPi, kPi);
    const double got = Heading::from_rad(first).turned(second).rad();
    ASSERT_NEAR(wrapped_rad(got - (first + second)), 0.0, 1e-14);
  }
}

TEST(Headings, StayOfLengthOneThroughAMillionTurns) {
  Heading heading;
  for (int i = 0; i < 1000000; ++i) {
    heading = heading.turned(0.37);
  }
  EXPECT_NEAR(heading.cos * heading.cos + heading.sin * heading.sin, 1.0, 1e-15);
}

TEST(Clipped, ShortensToTheLimitAndKeepsTheDirection) {
  const WorldVec v = clipped(WorldVec{30.0, 40.0}, 5.0);
  EXPECT_NEAR(v.x(), 3.0, 1e-15);
  EXPECT_NEAR(v.y(), 4.0, 1e-15);
}

TEST(Clipped, LeavesShortVectorsAsTheyAre) {
  const WorldVec v{3.0, 4.0};
  EXPECT_EQ(clipped(v, 5.0), v);
}

TEST(Clipped, MakesTheZeroVectorOfALimitOfZero) {
  EXPECT_EQ(clipped(WorldVec{3.0, 4.0}, 0.0), WorldVec{});
}

TEST(Unit, HasLengthOne) {
  Stream chance(5, "frames");
  for (int i = 0; i < kDraws; ++i) {
    ASSERT_NEAR(unit(any_vector(chance)).norm(), 1.0, 1e-15);
  }
}

TEST(Unit, OfTheZeroVectorIsZero) { EXPECT_EQ(unit(WorldVec{}), WorldVec{}); }

}  // namespace
}  // namespace tacit
