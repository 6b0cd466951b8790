#include "idl/overlay/ground.h"

#include <gtest/gtest.h>

#include "idl/types/config_error.h"
#include "tests/overlay/sample_map.h"

namespace tacit {
namespace {

MapGround ground(const std::string& text, Doors doors = Doors::Open) {
  return ground_of(map_of("MISSION-AREA 20 20\n" + text), doors);
}

double walled_m(const MapGround& ground) {
  double sum = 0.0;
  for (const MapSegment& wall : ground.walls) sum += length_m(wall);
  return sum;
}

TEST(Ground, HasTheMissionAreasSizeAndNoShift) {
  EXPECT_EQ(ground("").size.width_m, 20.0);
  EXPECT_EQ(ground("ORIGIN 3 4\nPP a 1 1").shift_m, MapPoint{});
}

TEST(Ground, WithoutAnAreaIsTheBoundingBoxWithAMetreAround) {
  const MapGround it = ground_of(map_of("WALL w 100 50 110 53"), Doors::Open);
  EXPECT_EQ(it.size.width_m, 12.0);
  EXPECT_EQ(it.size.height_m, 5.0);
  EXPECT_EQ(it.shift_m, (MapPoint{-99.0, -49.0}));
  EXPECT_EQ(it.walls.at(0).from, (MapPoint{1.0, 1.0}));
}

TEST(Ground, HasAnOpenDoorCutOutOfItsWall) {
  const MapGround it = ground("WALL w 0 5 10 5\nDOOR d 4 5 6 5");
  ASSERT_EQ(it.walls.size(), 2U);
  EXPECT_EQ(it.walls[0].to, (MapPoint{4.0, 5.0}));
  EXPECT_EQ(it.walls[1].from, (MapPoint{6.0, 5.0}));
}

TEST(Ground, HasAClosedDoorAsAWall) {
  EXPECT_DOUBLE_EQ(walled_m(ground("WALL w 0 5 4 5\nDOOR d 4 5 6 5", Doors::Closed)), 6.0);
}

TEST(Ground, HasAGapCutOutOfEveryWallThatItLeadsThrough) {
  const MapGround it = ground("WALL a 0 5 10 5\nWALL b 0 5.1 10 5.1\nGAP g 5 4.8 5 5.3 2");
  EXPECT_EQ(it.walls.size(), 4U);
  EXPECT_NEAR(walled_m(it), 16.0, 1e-9);
}

TEST(Ground, OpensAWallThatLiesWholeInAnOpening) {
  EXPECT_TRUE(ground("WALL shut 4 5 6 5\nGAP g 5 4 5 6 2").walls.empty());
  EXPECT_TRUE(ground("WALL shut 4.5 5 5.5 5\nDOOR d 4 5 6 5").walls.empty());
}

TEST(Ground, RefusesMoreWallsAndDoorsThanCanBeCompared) {
  std::string text;
  for (int i = 0; i < 20'001; ++i) text += "WALL w 0 0 1 1\nDOOR d 4 5 6 5\n";
  EXPECT_THROW((void)ground(text), ConfigError);
}

TEST(Ground, LeavesAWallAcrossADoorAlone) {
  EXPECT_DOUBLE_EQ(walled_m(ground("WALL w 5 0 5 10\nDOOR d 4 5 6 5")), 10.0);
}

TEST(Ground, TakesRoomsForWallsOnlyWhenThereIsNoWall) {
  EXPECT_DOUBLE_EQ(walled_m(ground("ROOM r 1 1 5 1 5 5 1 5\nDOOR d 1 1 5 1")), 12.0);
  EXPECT_DOUBLE_EQ(walled_m(ground("ROOM r 1 1 5 1 5 5 1 5\nWALL w 1 1 2 1")), 1.0);
}

TEST(Ground, TakesBoundariesForWallsOnlyWhenThereIsNeitherWallNorRoom) {
  EXPECT_DOUBLE_EQ(walled_m(ground("BOUNDARY b 1 1 5 1")), 4.0);
  EXPECT_DOUBLE_EQ(walled_m(ground("BOUNDARY b 1 1 5 1\nWALL w 1 1 2 1")), 1.0);
}

TEST(Ground, CutsWallsOffAtTheBorder) {
  const MapGround it = ground("WALL w 10 10 30 10\nWALL out 21 0 21 20\nOBSTACLE 25 1 1");
  ASSERT_EQ(it.walls.size(), 1U);
  EXPECT_EQ(it.walls[0].to, (MapPoint{20.0, 10.0}));
  EXPECT_TRUE(it.discs.empty());
}

TEST(Ground, TakesObstaclesRocksAndTreesForDiscsEachOnce) {
  const MapGround it = ground(
      "OBSTACLE 1 1 1\nOBJECT 1 1 1 Fixed DarkSeaGreen\nOBJECT 5 5 2 Fixed Black\n"
      "OBJECT 9 9 1 Fixed white\nOBJECT 9 9 1 Movable black");
  EXPECT_EQ(it.discs, (std::vector<std::vector<double>>{{1.0, 1.0, 1.0}, {5.0, 5.0, 2.0}}));
}

TEST(Ground, TakesMovableOrangeObjectsForMines) {
  const MapGround it = ground("OBJECT 3 4 1 Movable Orange\nOBJECT 3 4 1 Movable orange");
  EXPECT_EQ(it.mines, (std::vector<std::vector<double>>{{3.0, 4.0}}));
}

TEST(Ground, BeginsAtTheStartPlace) {
  EXPECT_EQ(ground("PP \"startplace*\" 3 4 0.2").start, (MapPoint{3.0, 4.0}));
  EXPECT_EQ(ground("PP other 3 4 0.2").start, std::nullopt);
}

}  // namespace
}  // namespace tacit
