#include "idl/types/elementary.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "idl/types/random.h"

namespace tacit {
namespace {

// The C library in extended precision is the measure.
using Exact = long double;

constexpr double kPromised = 4e-16;
constexpr int kDraws = 20000;

double error_of(double got, Exact exact) {
  return static_cast<double>(std::fabs(static_cast<Exact>(got) - exact));
}

double worst_sine_error(double widest_rad) {
  Stream chance(1, "angles");
  double worst = 0.0;
  for (int i = 0; i < kDraws; ++i) {
    const double angle = chance.uniform(-widest_rad, widest_rad);
    const SinCos got = sin_cos(angle);
    worst = std::max({worst, error_of(got.sin, std::sin(static_cast<Exact>(angle))),
                      error_of(got.cos, std::cos(static_cast<Exact>(angle)))});
  }
  return worst;
}

TEST(SinCosOf, IsExactEnoughWithinOneTurn) { EXPECT_LT(worst_sine_error(2.0 * kPi), kPromised); }

TEST(SinCosOf, IsExactEnoughWithinAThousandTurns) {
  EXPECT_LT(worst_sine_error(6300.0), kPromised);
}

TEST(SinCosOf, IsExactEnoughUpToAMillionRadians) { EXPECT_LT(worst_sine_error(1e6), kPromised); }

TEST(SinCosOf, KeepsTheSmallestAnglesAsTheyAre) {
  EXPECT_EQ(sin_cos(1e-300).sin, 1e-300);
  EXPECT_EQ(sin_cos(0.0).cos, 1.0);
}

TEST(SinCosOf, SitsOnTheUnitCircle) {
  Stream chance(2, "angles");
  for (int i = 0; i < kDraws; ++i) {
    const SinCos sc = sin_cos(chance.uniform(-100.0, 100.0));
    ASSERT_NEAR(sc.sin * sc.sin + sc.cos * sc.cos, 1.0, 1e-15);
  }
}

TEST(ArcTangent, IsExactEnoughForPointsOfEverySize) {
  Stream chance(3, "points");
  double worst = 0.0;
  for (int i = 0; i < kDraws; ++i) {
    const double x = std::ldexp(chance.uniform(-1.0, 1.0), static_cast<int>(chance.below(80)) - 40);
    const double y = std::ldexp(chance.uniform(-1.0, 1.0), static_cast<int>(chance.below(80)) - 40);
    const Exact exact = std::atan2(static_cast<Exact>(y), static_cast<Exact>(x));
    // Relative to the larger of 1 and the angle: near pi one unit in the last place is 4.4e-16.
    worst = std::max(worst, error_of(arc_tangent(y, x), exact) /
                                std::max(1.0, static_cast<double>(std::fabs(exact))));
  }
  EXPECT_LT(worst, kPromised);
}

TEST(ArcTangent, GivesTheAxesTheirAngles) {
  EXPECT_EQ(arc_tangent(0.0, 1.0), 0.0);
  EXPECT_EQ(arc_tangent(1.0, 0.0), kPi / 2);
  EXPECT_EQ(arc_tangent(0.0, -1.0), kPi);
  EXPECT_EQ(arc_tangent(-1.0, 0.0), -kPi / 2);
}

TEST(ArcTangent, TellsTheFourQuadrantsApart) {
  EXPECT_NEAR(arc_tangent(1.0, 1.0), 0.25 * kPi, 1e-15);
  EXPECT_NEAR(arc_tangent(1.0, -1.0), 0.75 * kPi, 1e-15);
  EXPECT_NEAR(arc_tangent(-1.0, -1.0), -0.75 * kPi, 1e-15);
  EXPECT_NEAR(arc_tangent(-1.0, 1.0), -0.25 * kPi, 1e-15);
}

TEST(ArcTangent, IsZeroForTheZeroVector) { EXPECT_EQ(arc_tangent(0.0, 0.0), 0.0); }

TEST(ArcTangent, UndoesSineAndCosine) {
  for (double angle = -3.14; angle < 3.14; angle += 0.001) {
    const SinCos sc = sin_cos(angle);
    ASSERT_NEAR(arc_tangent(sc.sin, sc.cos), angle, 1e-15);
  }
}

TEST(NaturalLog, IsExactEnoughFromTheSmallestToTheLargestNumber) {
  Stream chance(4, "numbers");
  double worst = 0.0;
  for (int i = 0; i < kDraws; ++i) {
    const double x =
        std::ldexp(chance.uniform(0.5, 1.0), static_cast<int>(chance.below(2000)) - 1000);
    const Exact exact = std::log(static_cast<Exact>(x));
    worst = std::max(worst, error_of(natural_log(x), exact) /
                                std::max(1.0, static_cast<double>(std::fabs(exact))));
  }
  EXPECT_LT(worst, kPromised);
}

TEST(NaturalLog, KeepsItsDigitsNearOne) {
  for (const double step : {1e-3, 1e-6, 1e-9, 1e-12}) {
    const double x = 1.0 + step;
    const auto exact = static_cast<double>(std::log(static_cast<Exact>(x)));
    EXPECT_NEAR(natural_log(x), exact, 4e-16 * step) << step;
  }
}

TEST(NaturalLog, IsZeroAtOne) { EXPECT_EQ(natural_log(1.0), 0.0); }

TEST(Wrapped, StaysWithinHalfATurn) {
  Stream chance(5, "angles");
  for (int i = 0; i < kDraws; ++i) {
    const double wrapped = wrapped_rad(chance.uniform(-1e4, 1e4));
    ASSERT_GT(wrapped, -kPi);
    ASSERT_LE(wrapped, kPi);
  }
}

TEST(Wrapped, PointsTheSameWay) {
  Stream chance(6, "angles");
  for (int i = 0; i < kDraws; ++i) {
    const double angle = chance.uniform(-100.0, 100.0);
    ASSERT_NEAR(sin_cos(wrapped_rad(angle)).sin, sin_cos(angle).sin, 1e-13);
    ASSERT_NEAR(sin_cos(wrapped_rad(angle)).cos, sin_cos(angle).cos, 1e-13);
  }
}

TEST(Wrapped, CallsHalfATurnPiFromEitherSide) {
  EXPECT_EQ(wrapped_rad(kPi), kPi);
  EXPECT_EQ(wrapped_rad(-kPi), kPi);
}

TEST(Wrapped, LeavesAnglesWithinHalfATurnAlone) {
  for (const double angle : {-3.0, -1e-9, 0.0, 0.5, 3.1}) {
    EXPECT_EQ(wrapped_rad(angle), angle);
  }
}

}  // namespace
}  // namespace tacit
