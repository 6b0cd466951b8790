#include "idl/overlay/plan.h"

#include <gtest/gtest.h>

#include "tests/overlay/sample_map.h"

namespace tacit {
namespace {

MapPlan plan(const std::string& text) { return plan_of(map_of(text), Doors::Open); }

TEST(Plan, HasDoorsFromJambToJamb) {
  const MapPlan it = plan("MISSION-AREA 9 9\nWALL w 0 5 9 5\nDOOR \"d*\" 4 5 6 5");
  EXPECT_EQ(it.doors, (std::vector<PlanDoor>{{"d", {4.0, 5.0}, {6.0, 5.0}, 2.0}}));
}

TEST(Plan, HasAGapsJambsAcrossTheWayThrough) {
  const MapPlan it = plan("MISSION-AREA 9 9\nWALL w 0 5 9 5\nGAP g 5 5.5 5 4.5 2");
  ASSERT_EQ(it.gaps.size(), 1U);
  EXPECT_EQ(it.gaps[0], (PlanDoor{"g", {4.0, 5.0}, {6.0, 5.0}, 2.0}));
  EXPECT_TRUE(it.doors.empty());
}

TEST(Plan, HasEverythingInTheWorldsFrame) {
  const MapPlan it = plan(
      "ROOM r 100 100 104 100 104 104 100 104\nPP \"p*\" 101 102 0.5\n"
      "OBJECT 103 103 0.2 Fixed brown\n"
      "HALLWAY h CENTERLINE 100 99 104 99 WIDTH 2 EXTENTS 100 98 104 98 104 100 100 100\n"
      "AA home 100 100 101 100 101 101\n");
  EXPECT_EQ(it.rooms.at(0).outline.at(0), (MapPoint{1.0, 3.0}));
  EXPECT_EQ(it.points, (std::vector<PlanPoint>{{"p", {2.0, 5.0}, 0.5}}));
  EXPECT_EQ(it.objects.at(0).centre, (MapPoint{4.0, 6.0}));
  EXPECT_EQ(it.halls.at(0).centre_line.at(0), (MapPoint{1.0, 2.0}));
  EXPECT_EQ(it.halls.at(0).outline.at(0), (MapPoint{1.0, 1.0}));
  EXPECT_EQ(it.areas.at(0).points.at(0), (MapPoint{1.0, 3.0}));
  EXPECT_EQ(it.ground.walls.at(0).from, (MapPoint{1.0, 3.0}));
}

TEST(Plan, TellsInWhichRoomAPointLies) {
  const MapPlan it =
      plan("MISSION-AREA 9 9\nROOM a 0 0 4 0 4 4 0 4\nROOM b 4 0 8 0 8 8 6 8 6 4 4 4\n");
  EXPECT_EQ(room_at(it.rooms, {1.0, 1.0}), 0U);
  EXPECT_EQ(room_at(it.rooms, {7.0, 7.0}), 1U);
  EXPECT_EQ(room_at(it.rooms, {5.0, 7.0}), std::nullopt);
  EXPECT_EQ(room_at(it.rooms, {8.0, 3.0}), 1U) << "on the rim";
}

}  // namespace
}  // namespace tacit
