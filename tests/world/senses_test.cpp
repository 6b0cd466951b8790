#include "world_server/world/sensing/senses.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/world/lookout.h"

namespace tacit {
namespace {

TEST(Senses, RecogniseWhatIsJustWithinRange) {
  Lookout lookout;
  lookout.enemies = {{50.0, 20.0}};
  EXPECT_EQ(lookout.seen(), 1u);
}

TEST(Senses, RecogniseNothingBeyondRange) {
  Lookout lookout;
  lookout.enemies = {{50.001, 20.0}};
  EXPECT_EQ(lookout.seen(), 0u);
}

TEST(Senses, CallEnemiesRedTeammatesBlueAndTheTargetWhite) {
  Lookout lookout;
  lookout.config.target = {20.0, 25.0, 1.5};
  lookout.config.enemies.radius_m = 0.3;
  lookout.teammates = {{{25.0, 20.0}, {}}};
  lookout.enemies = {{20.0, 15.0}};
  const Percept percept = lookout.percept();
  ASSERT_EQ(percept.sightings.size(), 3u);
  for (const Sighting& s : percept.sightings) {
    const bool target = s.offset_m == BodyVec{0.0, 5.0};
    const bool mate = s.offset_m == BodyVec{5.0, 0.0};
    EXPECT_EQ(s.kind, target ? Kind::Target : mate ? Kind::Teammate : Kind::Enemy);
    EXPECT_EQ(s.colour, target ? Colour::White : mate ? Colour::Blue : Colour::Red);
    EXPECT_EQ(s.radius_m, target ? 1.5 : mate ? lookout.config.robots.radius_m : 0.3);
  }
}

TEST(Senses, SeeTheTargetOnlyWithinRange) {
  Lookout lookout;
  EXPECT_EQ(lookout.seen(), 0u);
  lookout.config.target = {45.0, 20.0, 1.0};
  EXPECT_EQ(lookout.seen(), 1u);
}

TEST(Senses, DoNotSeeTheirOwnRobot) {
  Lookout lookout;
  EXPECT_TRUE(lookout.percept().sightings.empty());
}

TEST(Senses, EndAtTheEdgesOfTheFieldOfView) {
  Lookout lookout;
  lookout.config.sight.field_of_view_deg = 90.0;
  lookout.eye.heading = Heading::from_rad(0.7);
  for (const double degrees : {-44.9, 0.0, 44.9, -45.1, 45.1, 90.0, 180.0}) {
    const Heading way = lookout.eye.heading.turned(degrees * kPi / 180.0);
    lookout.enemies = {lookout.eye.position_m + 10.0 * WorldVec{way.cos, way.sin}};
    EXPECT_EQ(lookout.seen(), std::abs(degrees) < 45.0 ? 1u : 0u) << degrees;
  }
}

TEST(Senses, SeeMoreThanHalfTheHorizonWhenTheFieldIsWide) {
  Lookout lookout;
  lookout.config.sight.field_of_view_deg = 270.0;
  for (const double degrees : {-134.0, 134.0, -136.0, 136.0, 180.0}) {
    const Heading way = Heading::from_rad(degrees * kPi / 180.0);
    lookout.enemies = {lookout.eye.position_m + 10.0 * WorldVec{way.cos, way.sin}};
    EXPECT_EQ(lookout.seen(), std::abs(degrees) < 135.0 ? 1u : 0u) << degrees;
  }
}

TEST(Senses, SeeRightBehindWhenPanoramic) {
  Lookout lookout;
  lookout.enemies = {{10.0, 20.0}};
  EXPECT_EQ(lookout.seen(), 1u);
}

TEST(Senses, LoseWhatAnObstacleHidesWhenObstaclesBlock) {
  Lookout lookout;
  lookout.terrain.obstacles = {{{30.0, 20.0}, 2.0}};
  lookout.enemies = {{40.0, 20.0}};
  EXPECT_EQ(lookout.seen(), 0u);
  lookout.config.sight.blocked_by_obstacles = false;
  EXPECT_EQ(lookout.seen(), 1u);
}

TEST(Senses, LoseWhatAWallHidesWhenWallsBlock) {
  Lookout lookout;
  lookout.terrain.walls = {{{30.0, 10.0}, {30.0, 30.0}}};
  lookout.enemies = {{40.0, 20.0}};
  EXPECT_EQ(lookout.seen(), 0u);
  lookout.config.sight.blocked_by_walls = false;
  EXPECT_EQ(lookout.seen(), 1u);
}

TEST(Senses, LoseTheTargetBehindAWallLikeAnythingElse) {
  Lookout lookout;
  lookout.config.target = {40.0, 20.0, 1.0};
  lookout.terrain.walls = {{{30.0, 10.0}, {30.0, 30.0}}};
  EXPECT_EQ(lookout.seen(), 0u);
}

TEST(Senses, TurnWithTheRobot) {
  Stream chance(1, "turn");
  for (int round = 0; round < 200; ++round) {
    Lookout lookout;
    lookout.terrain.obstacles = {{{26.0, 18.0}, 2.0}};
    lookout.enemies = {{chance.uniform(5.0, 35.0), chance.uniform(22.0, 35.0)}};
    lookout.eye.heading = Heading::from_rad(chance.uniform(-kPi, kPi));
    const Percept percept = lookout.percept();
    ASSERT_EQ(percept.sightings.size(), 1u);
    ASSERT_EQ(percept.obstacles.size(), 1u);
    const auto in_world = [&lookout](const BodyVec& offset) {
      return lookout.eye.position_m + from_body<WorldFrame>(lookout.eye.heading, offset);
    };
    ASSERT_NEAR((in_world(percept.sightings[0].offset_m) - lookout.enemies[0]).norm(), 0.0, 1e-12);
    ASSERT_NEAR((in_world(percept.obstacles[0].offset_m) - WorldVec{26.0, 18.0}).norm(), 0.0,
                1e-12);
  }
}

TEST(RangeFinder, MeasuresToTheSurfaceOfAnObstacle) {
  Lookout lookout;
  lookout.config.sight.obstacle_range_m = 10.0;
  lookout.terrain.obstacles = {{{33.0, 20.0}, 3.0}};
  const Percept near = lookout.percept();
  ASSERT_EQ(near.obstacles.size(), 1u);
  EXPECT_EQ(near.obstacles[0].offset_m, (BodyVec{13.0, 0.0}));
  EXPECT_EQ(near.obstacles[0].radius_m, 3.0);
  lookout.terrain.obstacles = {{{33.01, 20.0}, 3.0}};
  EXPECT_TRUE(lookout.percept().obstacles.empty());
}

TEST(RangeFinder, SeesObstaclesBehindObstaclesAndBehindTheRobot) {
  Lookout lookout;
  lookout.config.sight.field_of_view_deg = 90.0;
  lookout.terrain.obstacles = {{{24.0, 20.0}, 1.0}, {{27.0, 20.0}, 1.0}, {{16.0, 20.0}, 1.0}};
  EXPECT_EQ(lookout.percept().obstacles.size(), 3u);
}

TEST(RangeFinder, ReturnsTheNearestPointOfAWallWithoutRadius) {
  Lookout lookout;
  lookout.terrain.walls = {{{25.0, 0.0}, {25.0, 100.0}}};
  const Percept percept = lookout.percept();
  ASSERT_EQ(percept.obstacles.size(), 1u);
  EXPECT_EQ(percept.obstacles[0].offset_m, (BodyVec{5.0, 0.0}));
  EXPECT_EQ(percept.obstacles[0].radius_m, 0.0);
}

TEST(RangeFinder, ReturnsTheBorderAsPointsWithoutRadius) {
  Lookout lookout;
  lookout.terrain.border_walls = true;
  lookout.config.sight.obstacle_range_m = 10.0;
  lookout.eye.position_m = {97.0, 4.0};
  const Percept percept = lookout.percept();
  ASSERT_EQ(percept.obstacles.size(), 2u);
  for (const SeenObstacle& seen : percept.obstacles) {
    EXPECT_TRUE(seen.offset_m == (BodyVec{3.0, 0.0}) || seen.offset_m == (BodyVec{0.0, -4.0}));
    EXPECT_EQ(seen.radius_m, 0.0);
  }
}

TEST(RangeFinder, FindsNoBorderWhereThereIsNone) {
  Lookout lookout;
  lookout.eye.position_m = {97.0, 4.0};
  EXPECT_TRUE(lookout.percept().obstacles.empty());
}

double farthest(const Percept& percept) {
  double most = 0.0;
  for (const Sighting& s : percept.sightings) {
    most = std::max(most, s.offset_m.norm());
  }
  return most;
}

TEST(FullSensors, KeepTheNearestSightings) {
  Lookout lookout;
  Stream chance(2, "crowd");
  for (int i = 0; i < 300; ++i) {
    // Ranges 0.1 m, 0.2 m, … in a shuffled order.
    const Heading way = Heading::from_rad(chance.uniform(-kPi, kPi));
    const double range = 0.1 * static_cast<double>(1 + (i * 77) % 300);
    lookout.enemies.push_back(lookout.eye.position_m + range * WorldVec{way.cos, way.sin});
  }
  const Percept percept = lookout.percept();
  EXPECT_EQ(percept.sightings.size(), Percept::kMaxSightings);
  EXPECT_NEAR(farthest(percept), 0.1 * Percept::kMaxSightings, 1e-9);
}

TEST(FullSensors, KeepANearThingAmongManyThatAreEquallyFar) {
  Lookout lookout;
  for (int i = 0; i < 200; ++i) {
    lookout.enemies.push_back({20.0, 30.0});
  }
  lookout.enemies.push_back({21.0, 20.0});
  const Percept percept = lookout.percept();
  EXPECT_EQ(percept.sightings.size(), Percept::kMaxSightings);
  EXPECT_TRUE(
      std::any_of(percept.sightings.begin(), percept.sightings.end(), [](const Sighting& s) {
        return s.offset_m == BodyVec{1.0, 0.0};
      }));
}

TEST(FullSensors, KeepTheNearestObstacles) {
  Lookout lookout;
  lookout.config.sight.obstacle_range_m = 50.0;
  for (int i = 0; i < 100; ++i) {
    const double range = 0.3 * static_cast<double>(1 + (i * 77) % 100);
    lookout.terrain.obstacles.push_back({{20.0 + range, 20.0}, 0.1});
  }
  const Percept percept = lookout.percept();
  EXPECT_EQ(percept.obstacles.size(), Percept::kMaxObstacles);
  for (const SeenObstacle& seen : percept.obstacles) {
    EXPECT_LE(seen.offset_m.norm(), 0.3 * Percept::kMaxObstacles + 1e-9);
  }
}

}  // namespace
}  // namespace tacit
