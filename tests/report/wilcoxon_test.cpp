#include "console/report/wilcoxon.h"

#include <gtest/gtest.h>

#include <array>
#include <vector>

namespace tacit {
namespace {

// Hollander & Wolfe, "Nonparametric statistical methods" (1973), table 3.1: depression scales of
// nine patients before and after. R's wilcox.test gives p = 0.03906 (V = 40).
const std::vector<double> kBefore{1.83, 0.50, 1.62, 2.48, 1.68, 1.88, 1.55, 3.06, 1.30};
const std::vector<double> kAfter{0.878, 0.647, 0.598, 2.05, 1.06, 1.29, 1.06, 3.14, 1.29};

// Student (1908): one pair is the same, two differ equally. R gives p = 0.009091 with corrections.
const std::vector<double> kDrug1{0.7, -1.6, -0.2, -1.2, -0.1, 3.4, 3.7, 0.8, 0.0, 2.0};
const std::vector<double> kDrug2{1.9, 0.8, 1.1, 0.1, -0.1, 4.4, 5.5, 1.6, 4.6, 3.4};

TEST(Wilcoxon, IsExactForAFewPairs) {
  EXPECT_NEAR(wilcoxon_signed_rank(kBefore, kAfter).value(), 20.0 / 512.0, 1e-12);
}

TEST(Wilcoxon, IsTheSameWithItsSamplesTurned) {
  EXPECT_EQ(wilcoxon_signed_rank(kBefore, kAfter), wilcoxon_signed_rank(kAfter, kBefore));
}

TEST(Wilcoxon, CorrectsForTiesAndLeavesOutEqualPairs) {
  EXPECT_NEAR(wilcoxon_signed_rank(kDrug1, kDrug2).value(), 0.009091, 5e-5);
}

TEST(Wilcoxon, OfOnePairCannotTell) {
  EXPECT_EQ(wilcoxon_signed_rank(std::array{1.0}, std::array{2.0}), 1.0);
}

TEST(Wilcoxon, OfEqualPairsIsAbsent) {
  EXPECT_EQ(wilcoxon_signed_rank(std::array{1.0, 2.0}, std::array{1.0, 2.0}), std::nullopt);
}

TEST(Wilcoxon, OfManyPairsComesCloseToTheExactValue) {
  std::vector<double> a;
  std::vector<double> b;
  for (int i = 1; i <= 50; ++i) {
    a.push_back(i % 3 == 0 ? -i : i);
    b.push_back(0.0);
  }
  const double exact = wilcoxon_signed_rank(a, b).value();
  a.push_back(0.001);
  b.push_back(0.0);
  EXPECT_NEAR(wilcoxon_signed_rank(a, b).value(), exact, 0.02 * exact + 0.002);
}

}  // namespace
}  // namespace tacit
