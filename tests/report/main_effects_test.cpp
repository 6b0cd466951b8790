#include "console/report/main_effects.h"

#include <gtest/gtest.h>

namespace tacit {
namespace {

/// Two factors of two and three levels, each combination twice: 10 i, 2 j and a residual of ±1.
std::vector<Observation> table() {
  std::vector<Observation> all;
  for (const std::size_t i : {0U, 1U}) {
    for (const std::size_t j : {0U, 1U, 2U}) {
      for (const double residual : {-1.0, 1.0}) {
        all.push_back(
            {10.0 * static_cast<double>(i) + 2.0 * static_cast<double>(j) + residual, {i, j}});
      }
    }
  }
  return all;
}

// By hand: 12 (5^2) = 300, 4 (2^2 + 0 + 2^2) = 32, 12 (1^2) = 12, in all 344.
TEST(MainEffects, AreTheSharesOfTheSquares) {
  const auto effects = main_effects(table());
  ASSERT_EQ(effects.size(), 3U);
  EXPECT_NEAR(effects[0].eta_squared, 300.0 / 344.0, 1e-12);
  EXPECT_NEAR(effects[1].eta_squared, 32.0 / 344.0, 1e-12);
  EXPECT_NEAR(effects[2].eta_squared, 12.0 / 344.0, 1e-12);
}

TEST(MainEffects, HaveOneDegreeOfFreedomLessThanLevels) {
  const auto effects = main_effects(table());
  EXPECT_EQ(effects.at(0).degrees, 1U);
  EXPECT_EQ(effects.at(1).degrees, 2U);
  EXPECT_EQ(effects.at(2).degrees, 8U);
}

// F = (32 / 2) / (12 / 8) = 10.67; the upper 1 % point of F(2, 8) is 8.649, the 0.1 % one 18.49.
TEST(MainEffects, AreTestedAgainstTheResidual) {
  const MainEffect second = main_effects(table()).at(1);
  EXPECT_NEAR(second.f.value(), 32.0 / 3.0, 1e-12);
  EXPECT_LT(second.p_value.value(), 0.01);
  EXPECT_GT(second.p_value.value(), 0.001);
}

TEST(MainEffects, GiveTheResidualNoTest) {
  EXPECT_FALSE(main_effects(table()).back().p_value.has_value());
}

TEST(MainEffects, OfWhatDoesNotVaryAreNone) {
  const std::vector<Observation> same{{1.0, {0}}, {1.0, {1}}, {1.0, {0}}};
  EXPECT_TRUE(main_effects(same).empty());
}

}  // namespace
}  // namespace tacit
