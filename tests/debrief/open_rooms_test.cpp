#include "console/debrief/open_rooms.h"

#include <gtest/gtest.h>

#include "tests/debrief/story.h"

namespace tacit {
namespace {

const std::string kRoom = "MISSION-AREA 20 20\nROOM \"r\" 2 2 8 2 8 8 2 8\n";

bool is_open(const std::string& opening, Doors doors = Doors::Open) {
  return open_rooms(plan_in(kRoom + opening), doors).at(0);
}

TEST(OpenRooms, HaveADoorOnTheirOutline) {
  EXPECT_TRUE(is_open("DOOR d 4 8 5 8\n"));
  EXPECT_TRUE(is_open("DOOR d 8.1 4 8.1 5\n")) << "in a double wall";
  EXPECT_FALSE(is_open("DOOR d 4 9 5 9\n"));
  EXPECT_FALSE(is_open("DOOR d 9 8 10 8\n")) << "in the same line, elsewhere";
  EXPECT_FALSE(is_open(""));
}

TEST(OpenRooms, HaveAGapThroughTheirOutline) {
  EXPECT_TRUE(is_open("GAP g 5 7.9 5 8.1 1\n"));
  EXPECT_TRUE(is_open("GAP g 5 7.9 5 8.7 1\n")) << "longer to one side";
  EXPECT_FALSE(is_open("GAP g 5 9.9 5 10.1 1\n"));
  EXPECT_FALSE(is_open("GAP g 12 7.9 12 8.1 1\n"));
  EXPECT_FALSE(is_open("GAP g 5 8 5 8 1\n")) << "leads nowhere";
}

TEST(OpenRooms, AreShutWithTheirDoors) {
  EXPECT_FALSE(is_open("DOOR d 4 8 5 8\n", Doors::Closed));
  EXPECT_TRUE(is_open("GAP g 5 7.9 5 8.1 1\n", Doors::Closed));
}

TEST(OpenRooms, ShareADoorBetweenThem) {
  const MapPlan plan = plan_in(kRoom + "ROOM s 8 2 14 2 14 8 8 8\nDOOR d 8 4 8 5\n");
  EXPECT_EQ(open_rooms(plan, Doors::Open), (std::vector<bool>{true, true}));
}

TEST(RoomsAt, AreTheFirstThatHoldThePoint) {
  const MapPlan plan = plan_in(kRoom + "ROOM s 8 2 14 2 14 8 8 8\n");
  EXPECT_EQ(rooms_at(plan, {{3, 3}, {10, 3}, {8, 3}, {15, 3}}),
            (std::vector<std::uint32_t>{1, 2, 1, 0}));
}

}  // namespace
}  // namespace tacit
