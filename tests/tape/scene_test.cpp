#include "console/tape/scene.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace tacit {
namespace {

const Marker& find(const std::vector<Marker>& scene, const std::string& group) {
  const auto found = std::find_if(scene.begin(), scene.end(),
                                  [&](const Marker& marker) { return marker.group == group; });
  EXPECT_NE(found, scene.end()) << group;
  return *found;
}

TEST(Scene, DrawsWallsAndTheBorder) {
  Scenery scenery;
  scenery.width_m = 20;
  scenery.height_m = 10;
  scenery.walls = {{1, 2, 3, 4}};
  EXPECT_EQ(find(still_scene(scenery), "walls").points.size(), 2U);
  scenery.border_walls = true;
  EXPECT_EQ(find(still_scene(scenery), "walls").points.size(), 10U);
}

TEST(Scene, DrawsObstaclesAndThePlaceThatTheMissionIsAbout) {
  Scenery scenery;
  scenery.discs = {{5, 6, 2}};
  scenery.focus = Scenery::Place{1, 2, 3};
  const auto scene = still_scene(scenery);
  EXPECT_EQ(find(scene, "obstacles").scale.x, 4.0);
  EXPECT_EQ(find(scene, "place").position.y, 2.0);
}

TEST(Scene, DrawsARobotWhereItIsAndAsItStands) {
  WorldView view;
  view.robots.resize(1);
  view.robots[0].robot = {4};
  view.robots[0].pose = {{2.0, 3.0}, Heading::from_rad(2.0)};
  const auto scene = moving_scene(view, 0.2);
  EXPECT_EQ(find(scene, "robots").position.x, 2.0);
  EXPECT_EQ(find(scene, "names").text, "4");
  EXPECT_NEAR(find(scene, "headings").turn_cos, std::cos(1.0), 1e-9);
  EXPECT_NEAR(find(scene, "headings").turn_sin, std::sin(1.0), 1e-9);
}

TEST(Scene, DrawsARobotThatIsLostGrey) {
  WorldView view;
  view.robots.resize(1);
  view.robots[0].robot = {1};
  const float blue = find(moving_scene(view, 0.2), "robots").paint.b;
  view.robots[0].present = false;
  EXPECT_NE(find(moving_scene(view, 0.2), "robots").paint.b, blue);
}

TEST(Scene, TakesEnemiesAwayWhenThereAreNoneLeft) {
  WorldView view;
  view.enemies.resize(2);
  EXPECT_EQ(find(moving_scene(view, 0.2), "enemies").points.size(), 2U);
  view.enemies.clear();
  EXPECT_EQ(find(moving_scene(view, 0.2), "enemies").action, Marker::Action::Delete);
}

}  // namespace
}  // namespace tacit
