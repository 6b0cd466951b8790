#include "idl/types/repulsion.h"

#include <gtest/gtest.h>

namespace tacit {
namespace {

constexpr double kReach = 3.0;
constexpr double kMargin = 0.5;

TEST(Repulsion, IsNothingFromTheReachOutwards) {
  EXPECT_EQ(repulsion(kReach, kReach, kMargin), 0.0);
  EXPECT_EQ(repulsion(100.0, kReach, kMargin), 0.0);
}

TEST(Repulsion, GrowsEvenlyToOneJustOutsideTheMargin) {
  EXPECT_DOUBLE_EQ(repulsion(0.5 * (kReach + kMargin), kReach, kMargin), 0.5);
  EXPECT_NEAR(repulsion(kMargin + 1e-9, kReach, kMargin), 1.0, 1e-8);
}

TEST(Repulsion, OutweighsEverythingInsideTheMargin) {
  EXPECT_EQ(repulsion(kMargin, kReach, kMargin), kInfiniteRepulsion);
  EXPECT_EQ(repulsion(-1.0, kReach, kMargin), kInfiniteRepulsion);
}

}  // namespace
}  // namespace tacit
