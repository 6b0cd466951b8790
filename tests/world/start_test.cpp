#include "world_server/world/start.h"

#include <gtest/gtest.h>

#include "idl/types/config_error.h"
#include "tests/world/sample_worlds.h"

namespace tacit {
namespace {

std::vector<WorldPose> starts(const WorldConfig& config, std::uint64_t seed = 1) {
  return start_poses(config, make_terrain(config, seed), seed);
}

TEST(RingStart, SpreadsTheTeamEvenlyRoundTheTargetFacingOutwards) {
  const WorldConfig config = empty_world(5);
  const std::vector<WorldPose> poses = starts(config);
  ASSERT_EQ(poses.size(), 5u);
  for (std::size_t i = 0; i < poses.size(); ++i) {
    const WorldVec out = poses[i].position_m - WorldVec{50.0, 50.0};
    EXPECT_NEAR(out.norm(), config.robots.ring_radius_m, 1e-12);
    EXPECT_NEAR(wrapped_rad(arc_tangent(out.y(), out.x()) - 2.0 * kPi * static_cast<double>(i) / 5),
                0.0, 1e-12);
    EXPECT_NEAR(wrapped_rad(poses[i].heading.rad() - arc_tangent(out.y(), out.x())), 0.0, 1e-12);
  }
}

WorldConfig scattered(std::int64_t robots) {
  WorldConfig config = busy_world(robots);
  config.robots.start = "scattered";
  return config;
}

TEST(ScatteredStart, PutsNoRobotInAnObstacleOrInAnotherOrOutside) {
  const WorldConfig config = scattered(300);
  const double r = config.robots.radius_m;
  const Terrain terrain = make_terrain(config, 1);
  const std::vector<WorldPose> poses = start_poses(config, terrain, 1);
  ASSERT_EQ(poses.size(), 300u);
  for (std::size_t i = 0; i < poses.size(); ++i) {
    const WorldVec p = poses[i].position_m;
    ASSERT_GE(std::min({p.x(), p.y(), 60.0 - p.x(), 60.0 - p.y()}), r);
    for (const Disc& disc : terrain.obstacles) {
      ASSERT_GE((disc.centre_m - p).norm(), disc.radius_m + r);
    }
    for (std::size_t j = 0; j < i; ++j) {
      ASSERT_GE((poses[j].position_m - p).norm(), 2.0 * r);
    }
  }
}

TEST(ScatteredStart, KeepsRobotsOffWalls) {
  WorldConfig config = scattered(200);
  config.obstacles.coverage_percent = 0.0;
  config.area.walls = {{0.0, 10.0, 60.0, 10.0}};
  for (const WorldPose& pose : starts(config)) {
    ASSERT_GE(std::abs(pose.position_m.y() - 10.0), config.robots.radius_m);
  }
}

TEST(ScatteredStart, IsTheSameForTheSameSeedAndAnotherForAnother) {
  const WorldConfig config = scattered(3);
  EXPECT_EQ(starts(config, 1)[0].position_m, starts(config, 1)[0].position_m);
  EXPECT_FALSE(starts(config, 1)[0].position_m == starts(config, 2)[0].position_m);
}

TEST(Start, RefusesATeamWithoutRoomAndNamesTheRobot) {
  WorldConfig config = empty_world(6);
  config.robots.ring_radius_m = 0.3;
  EXPECT_NE(refusal(config).find("[robots] count = 6: no room for robot 2"), std::string::npos)
      << refusal(config);
}

TEST(Start, RefusesARobotInsideAGivenObstacle) {
  WorldConfig config = empty_world(1);
  config.obstacles.discs = {{60.0, 50.0, 1.0}};
  EXPECT_NE(refusal(config).find("no room for robot 1"), std::string::npos);
}

WorldConfig gathered(std::int64_t robots) {
  WorldConfig config = empty_world(robots);
  config.robots.start = "gathered";
  return config;
}

TEST(GatheredStart, PutsTheFirstRobotOnTheTargetAndTheOthersNearWithoutTouching) {
  const WorldConfig config = gathered(20);
  const std::vector<WorldPose> poses = starts(config);
  ASSERT_EQ(poses.size(), 20u);
  EXPECT_EQ(poses[0].position_m, (WorldVec{50.0, 50.0}));
  for (std::size_t i = 0; i < poses.size(); ++i) {
    EXPECT_LT((poses[i].position_m - WorldVec{50.0, 50.0}).norm(), 20.0 * config.robots.radius_m);
    for (std::size_t j = 0; j < i; ++j) {
      ASSERT_GT((poses[j].position_m - poses[i].position_m).norm(), 2.0 * config.robots.radius_m);
    }
  }
}

TEST(GatheredStart, StaysOnOneSideOfAWall) {
  WorldConfig config = gathered(60);
  config.area.walls = {{50.5, 0.0, 50.5, 100.0}};
  for (const WorldPose& pose : starts(config)) {
    ASSERT_LT(pose.position_m.x(), 50.5 - config.robots.radius_m);
  }
}

TEST(GatheredStart, GoesElsewhereWhenThereIsNoRoomAtTheTarget) {
  WorldConfig config = gathered(3);
  config.obstacles.discs = {{50.0, 50.0, 3.0}};
  for (const WorldPose& pose : starts(config)) {
    ASSERT_GT((pose.position_m - WorldVec{50.0, 50.0}).norm(), 3.0 + config.robots.radius_m);
  }
}

TEST(GatheredStart, RefusesATeamThatIsShutInTooSmallARoom) {
  WorldConfig config = gathered(500);
  config.area.width_m = config.area.height_m = 4.0;
  config.target.x_m = config.target.y_m = 2.0;
  EXPECT_THROW((void)starts(config), ConfigError);
}

}  // namespace
}  // namespace tacit
