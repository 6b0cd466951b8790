#include "console/report/holm.h"

#include <gtest/gtest.h>

#include <array>

namespace tacit {
namespace {

// Reckoned by hand by the rule of Holm (1979): sorted 0.005 x 4, 0.01 x 3, 0.03 x 2, and 0.04,
// which may not fall below its predecessor.
TEST(HolmCorrected, FollowsTheRuleStepByStep) {
  const auto corrected = holm_corrected(std::array{0.01, 0.04, 0.03, 0.005});

  ASSERT_EQ(corrected.size(), 4);
  EXPECT_DOUBLE_EQ(corrected[0], 0.03);
  EXPECT_DOUBLE_EQ(corrected[1], 0.06);
  EXPECT_DOUBLE_EQ(corrected[2], 0.06);
  EXPECT_DOUBLE_EQ(corrected[3], 0.02);
}

TEST(HolmCorrected, StaysAtMostOne) {
  EXPECT_EQ(holm_corrected(std::array{0.6, 0.7}), (std::vector<double>{1.0, 1.0}));
}

TEST(HolmCorrected, LeavesASingleTestAlone) {
  EXPECT_EQ(holm_corrected(std::array{0.04}), std::vector<double>{0.04});
}

TEST(HolmCorrected, OfNothingIsNothing) { EXPECT_TRUE(holm_corrected({}).empty()); }

}  // namespace
}  // namespace tacit
