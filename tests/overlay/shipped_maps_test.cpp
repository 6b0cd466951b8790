// The maps that ship, under deploy/maps.

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "idl/overlay/plan.h"
#include "idl/overlay/writer.h"
#include "tests/overlay/flood.h"
#include "tests/overlay/sample_map.h"

namespace tacit {
namespace {

std::string text_of(const std::string& name) {
  std::ifstream in(std::filesystem::path(TACIT_SOURCE_DIR) / "deploy/maps" / (name + ".ovl"));
  return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

MapPlan plan(const std::string& name) { return plan_of(map_of(text_of(name)), Doors::Open); }

std::ptrdiff_t objects(const MapPlan& plan, const std::string& colour, Mobility mobility) {
  return std::count_if(plan.objects.begin(), plan.objects.end(), [&](const MapObject& object) {
    return object.colour == colour && object.mobility == mobility;
  });
}

class ShippedMap : public testing::TestWithParam<const char*> {};

TEST_P(ShippedMap, IsWithoutAnyFindingAndInOneForm) {
  const std::string text = text_of(GetParam());
  ASSERT_FALSE(text.empty());
  EXPECT_EQ(findings_of(text), "");
  EXPECT_EQ(to_canonical_text(map_of(text)), text);
}

TEST_P(ShippedMap, HasAStartPlaceFromWhichEveryPointIsReached) {
  const MapPlan it = plan(GetParam());
  ASSERT_TRUE(it.ground.start.has_value());
  const Flood flood(it);
  for (const PlanPoint& point : it.points) EXPECT_TRUE(flood.reaches(point.at)) << point.name;
}

TEST_P(ShippedMap, HasEveryRoomWithADoorWithinReachAndNoOther) {
  const MapPlan it = plan(GetParam());
  const Flood flood(it);
  for (const PlanRoom& room : it.rooms) {
    EXPECT_EQ(flood.reaches(room), has_door(it, room)) << room.name;
  }
}

INSTANTIATE_TEST_SUITE_P(Each, ShippedMap,
                         testing::Values("hostage", "minefield", "office", "rescue", "waypoints"));

TEST(ShippedOffice, HasFourOpenRoomsAndOneRealSuspectAmongThree) {
  const MapPlan it = plan("office");
  EXPECT_EQ(it.doors.size(), 4U);
  EXPECT_EQ(objects(it, "brown", Mobility::Movable), 1);
  EXPECT_EQ(objects(it, "brown", Mobility::Fixed), 2);
  ASSERT_EQ(it.halls.size(), 1U);
  EXPECT_TRUE(holds_point(it.halls[0].outline, *it.ground.start));
  for (const MapObject& object : it.objects) {
    if (object.colour != "brown") continue;
    const auto room = room_at(it.rooms, object.centre);
    ASSERT_TRUE(room.has_value());
    EXPECT_TRUE(has_door(it, it.rooms[*room]));
  }
}

TEST(ShippedMinefield, HasItsMinesOutsideAllObstacles) {
  const MapPlan it = plan("minefield");
  EXPECT_EQ(it.ground.mines.size(), 6U);
  EXPECT_EQ(objects(it, "orange", Mobility::Movable), 6);
  EXPECT_EQ(objects(it, "green", Mobility::Container), 1);
}

TEST(ShippedRescueAndHostage, HavePeopleWithinReach) {
  for (const char* name : {"rescue", "hostage"}) {
    const MapPlan it = plan(name);
    const Flood flood(it);
    int people = 0;
    for (const MapObject& object : it.objects) {
      if (object.colour != "lightblue") continue;
      ++people;
      EXPECT_TRUE(flood.reaches(object.centre)) << name;
    }
    EXPECT_EQ(people, std::string(name) == "rescue" ? 3 : 1);
  }
}

}  // namespace
}  // namespace tacit
