#include "world_server/world/stage.h"

#include <gtest/gtest.h>

#include "tests/world/forage_field.h"

namespace tacit {
namespace {

// Robots 1 to 4 stand 2 m east, north, west and south of the base.
struct Four {
  Stage stage{bare_field(4), 1};

  [[nodiscard]] std::size_t nearest(const WorldVec& place_m, double range_m) const {
    return stage.nearest_robot(place_m, range_m, [](std::size_t) { return true; });
  }
};

TEST(Stage, FindsTheNearestRobot) {
  const Four four;
  EXPECT_EQ(four.nearest({18.5, 20.1}, 10.0), 2u);
  EXPECT_EQ(four.nearest({20.1, 18.5}, 10.0), 3u);
}

TEST(Stage, FindsTheLowestIdOfEquallyNearRobots) {
  EXPECT_EQ(Four().nearest({20.0, 20.0}, 10.0), 0u);
}

TEST(Stage, FindsNobodyOutOfRange) {
  EXPECT_EQ(Four().nearest({20.0, 20.0}, 2.0), 0u);
  EXPECT_EQ(Four().nearest({20.0, 20.0}, 1.99), kNobody);
}

TEST(Stage, FindsOnlyRobotsThatFit) {
  const Four four;
  const auto third = [](std::size_t robot) { return robot == 2; };
  EXPECT_EQ(four.stage.nearest_robot({22.0, 20.0}, 10.0, third), 2u);
}

}  // namespace
}  // namespace tacit
