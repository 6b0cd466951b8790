#include "idl/overlay/office.h"

#include <gtest/gtest.h>

#include <set>

#include "idl/overlay/plan.h"
#include "idl/overlay/writer.h"
#include "idl/types/config_error.h"
#include "tests/overlay/flood.h"
#include "tests/overlay/sample_map.h"

namespace tacit {
namespace {

constexpr std::uint64_t kSeeds = 1000;

std::vector<MapObject> suspects(const MapPlan& plan) {
  std::vector<MapObject> found = plan.objects;
  std::erase_if(found, [](const MapObject& object) { return object.colour != "brown"; });
  return found;
}

std::string findings(const OverlayMap& map) { return findings_of(to_text(map)); }

TEST(RandomOffice, IsWithoutAnyFindingForEverySeed) {
  for (std::uint64_t seed = 0; seed < kSeeds; ++seed) {
    const OverlayMap office = random_office(seed, {});
    ASSERT_EQ(findings(office), "") << "seed " << seed;
    ASSERT_EQ(map_of(to_text(office)), office) << "seed " << seed;
  }
}

TEST(RandomOffice, HasEveryOpenRoomAndNoClosedOneWithinReach) {
  for (std::uint64_t seed = 0; seed < kSeeds; ++seed) {
    const MapPlan plan = plan_of(random_office(seed, {}), Doors::Open);
    const Flood flood(plan);
    for (const PlanRoom& room : plan.rooms) {
      ASSERT_EQ(flood.reaches(room), has_door(plan, room)) << "seed " << seed << ' ' << room.name;
    }
    for (const PlanPoint& point : plan.points) {
      ASSERT_TRUE(flood.reaches(point.at)) << "seed " << seed << ' ' << point.name;
    }
  }
}

TEST(RandomOffice, CanBeComeToFromOutsideByWayPoints) {
  for (std::uint64_t seed = 0; seed < kSeeds; ++seed) {
    const OverlayMap office = random_office(seed, {.approach = true});
    ASSERT_EQ(findings(office), "") << "seed " << seed;
    const MapPlan plan = plan_of(office, Doors::Open);
    const Flood flood(plan);
    ASSERT_FALSE(holds_point(plan.halls.front().outline, *plan.ground.start));
    std::size_t way_points = 0;
    for (const PlanPoint& point : plan.points) {
      ASSERT_TRUE(flood.reaches(point.at)) << "seed " << seed << ' ' << point.name;
      way_points += point.name.starts_with("Way") || point.name == "Entry" ? 1 : 0;
    }
    ASSERT_EQ(way_points, 3U);
  }
}

TEST(RandomOffice, HasItsSuspectsInOpenRoomsEachInAnotherAndOneThatCanBeMoved) {
  for (std::uint64_t seed = 0; seed < kSeeds; ++seed) {
    const MapPlan plan = plan_of(random_office(seed, {}), Doors::Open);
    std::set<std::size_t> rooms;
    int movable = 0;
    for (const MapObject& suspect : suspects(plan)) {
      const auto room = room_at(plan.rooms, suspect.centre);
      ASSERT_TRUE(room.has_value()) << "seed " << seed;
      ASSERT_TRUE(has_door(plan, plan.rooms[*room])) << "seed " << seed;
      ASSERT_TRUE(rooms.insert(*room).second) << "seed " << seed;
      movable += suspect.mobility == Mobility::Movable ? 1 : 0;
    }
    ASSERT_EQ(movable, 1) << "seed " << seed;
  }
}

TEST(RandomOffice, BeginsInItsHallway) {
  for (std::uint64_t seed = 0; seed < kSeeds; ++seed) {
    const MapPlan plan = plan_of(random_office(seed, {}), Doors::Open);
    ASSERT_EQ(plan.halls.size(), 1U);
    ASSERT_TRUE(holds_point(plan.halls[0].outline, *plan.ground.start)) << "seed " << seed;
  }
}

TEST(RandomOffice, IsAsWished) {
  for (std::int64_t rooms = 2; rooms <= 8; ++rooms) {
    const OverlayMap map =
        random_office(3, {.rooms = rooms, .closed_rooms = 1, .suspects = 1, .sentry = false});
    const MapPlan plan = plan_of(map, Doors::Open);
    EXPECT_EQ(plan.rooms.size(), static_cast<std::size_t>(rooms));
    EXPECT_EQ(plan.doors.size(), plan.rooms.size() - 1);
    EXPECT_EQ(suspects(plan).size(), 1U);
    EXPECT_EQ(plan.points.size(), 1U);
    EXPECT_TRUE(plan.gaps.empty());
    EXPECT_EQ(findings(map), "");
  }
}

TEST(RandomOffice, IsTheSameForTheSameSeedAndAnotherForAnother) {
  EXPECT_EQ(to_text(random_office(5, {})), to_text(random_office(5, {})));
  EXPECT_NE(to_text(random_office(5, {})), to_text(random_office(6, {})));
}

TEST(RandomOffice, RefusesWhatCannotBe) {
  EXPECT_THROW((void)random_office(1, {.rooms = 1}), ConfigError);
  EXPECT_THROW((void)random_office(1, {.rooms = 9}), ConfigError);
  EXPECT_THROW((void)random_office(1, {.rooms = 2, .closed_rooms = 2}), ConfigError);
  EXPECT_THROW((void)random_office(1, {.rooms = 2, .suspects = 3}), ConfigError);
  EXPECT_THROW((void)random_office(1, {.rooms = 2, .closed_rooms = 1, .suspects = 2}), ConfigError);
}

}  // namespace
}  // namespace tacit
