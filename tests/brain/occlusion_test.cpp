#include "robot_agent/brain/perception/occlusion.h"

#include <gtest/gtest.h>

#include <array>

#include "tests/brain/percepts.h"

namespace tacit {
namespace {

using testing::seen;

Seen at(double range_m, double angle_deg) {
  const SinCos sc = sin_cos(angle_deg * kPi / 180.0);
  return seen(range_m * sc.cos, range_m * sc.sin);
}

bool occludes(const Seen& mate) {
  const Occlusion occlusion{Occlusion::Config{.angle_deg = 15.0}};
  return occlusion.occluded({20.0, 0.0}, std::array{mate});
}

TEST(Occlusion, ReachesFifteenDegreesToEitherSide) {
  EXPECT_TRUE(occludes(at(10.0, 14.99)));
  EXPECT_TRUE(occludes(at(10.0, -14.99)));
  EXPECT_FALSE(occludes(at(10.0, 15.01)));
  EXPECT_FALSE(occludes(at(10.0, -15.01)));
}

TEST(Occlusion, NeedsATeammateThatIsNearerToTheGroup) {
  EXPECT_TRUE(occludes(seen(39.99, 0.0)));
  EXPECT_FALSE(occludes(seen(40.01, 0.0)));
}

TEST(Occlusion, IsNotDoneByATeammateBehind) { EXPECT_FALSE(occludes(seen(-1.0, 0.0))); }

TEST(Occlusion, IsNotDoneByADisabledTeammate) {
  Seen mate = seen(10.0, 0.0);
  mate.able = false;
  EXPECT_FALSE(occludes(mate));
}

TEST(Occlusion, OfAHalfTurnStillNeedsANearerTeammate) {
  const Occlusion occlusion{Occlusion::Config{.angle_deg = 180.0}};
  EXPECT_TRUE(occlusion.occluded({20.0, 0.0}, std::array{at(10.0, 70.0)}));
  EXPECT_FALSE(occlusion.occluded({20.0, 0.0}, std::array{at(10.0, 100.0)}));
}

TEST(Occlusion, CountsEveryInterceptor) {
  const Occlusion occlusion{Occlusion::Config{}};
  const std::array mates{seen(10.0, 0.0), seen(5.0, 1.0), seen(0.0, 5.0), seen(15.0, -1.0)};
  EXPECT_EQ(occlusion.interceptors({20.0, 0.0}, mates), 3U);
}

}  // namespace
}  // namespace tacit
