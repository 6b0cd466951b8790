#include <gtest/gtest.h>

#include "tests/world/operation_field.h"

namespace tacit {
namespace {

void expect_near(const BodyVec& got, const BodyVec& wanted) {
  EXPECT_NEAR(got.x(), wanted.x(), 1e-9);
  EXPECT_NEAR(got.y(), wanted.y(), 1e-9);
}

Site site_at(double x_m, double y_m, const std::string& more = "") {
  return Field(on_floor({{x_m, y_m, 0.0}}, more)).percept(1).site;
}

TEST(Site, IsARoomAHallwayOrTheOpen) {
  EXPECT_EQ(site_at(2.0, 8.0), Site::Room);
  EXPECT_EQ(site_at(2.0, 5.0), Site::Hallway);
  EXPECT_EQ(site_at(2.0, 2.0), Site::Open);
}

TEST(Site, IsARoomWhereARoomAndAHallwayOverlap) {
  EXPECT_EQ(site_at(2.0, 5.0, "ROOM D 0 4 4 4 4 6 0 6\n"), Site::Room);
}

TEST(Site, IsToldAtTheStartAndWhereverItChanges) {
  Field field(on_floor({{6.0, 5.0, 90.0}, {15.0, 8.0, 0.0}}));
  field.step({acting(1, Act::None, {1.0, 0.0})});
  EXPECT_EQ(field.all<SiteEntered>(), (std::vector<SiteEntered>{{RobotId{1}, Site::Hallway, 1},
                                                                {RobotId{2}, Site::Room, 2}}));
  std::vector<SiteEntered> later;
  for (int i = 0; i < 30; ++i) {
    field.step({acting(1, Act::None, {1.0, 0.0})});
    for (const SiteEntered& each : field.all<SiteEntered>()) {
      later.push_back(each);
    }
  }
  EXPECT_EQ(later, (std::vector<SiteEntered>{{RobotId{1}, Site::Room, 1}}));
  EXPECT_EQ(field.percept(1).site, Site::Room);
}

TEST(Hallway, LiesAsItLiesRoundTheRobot) {
  const Field field(on_floor({{6.0, 5.5, 90.0}}));
  const std::optional<SeenHallway>& hallway = field.percept(1).hallway;
  ASSERT_TRUE(hallway);
  expect_near(hallway->offset_m, {-0.5, 0.0});
  expect_near(hallway->along, {0.0, -1.0});
  EXPECT_NEAR(hallway->ahead_m, 14.0, 1e-9);
  EXPECT_NEAR(hallway->behind_m, 6.0, 1e-9);
  EXPECT_EQ(hallway->width_m, 2.0);
}

TEST(Hallway, IsMeasuredAlongItsBends) {
  const std::string bent =
      "HALLWAY k CENTERLINE 2 1 8 1 8 1 8 3 WIDTH 1 EXTENTS 1 0.3 9 0.3 9 3.9 1 3.9\n";
  const Field field(on_floor({{5.0, 1.5, 0.0}, {8.5, 2.5, 0.0}}, bent));
  ASSERT_TRUE(field.percept(1).hallway);
  EXPECT_NEAR(field.percept(1).hallway->ahead_m, 5.0, 1e-9);
  EXPECT_NEAR(field.percept(1).hallway->behind_m, 3.0, 1e-9);
  ASSERT_TRUE(field.percept(2).hallway);
  expect_near(field.percept(2).hallway->along, {0.0, 1.0});
  EXPECT_NEAR(field.percept(2).hallway->ahead_m, 0.5, 1e-9);
  EXPECT_NEAR(field.percept(2).hallway->behind_m, 7.5, 1e-9);
}

TEST(Hallway, IsNoneElsewhere) {
  EXPECT_FALSE(Field(on_floor({{2.0, 8.0, 0.0}})).percept(1).hallway);
}

TEST(Doorway, IsSeenWithItsJambTheNearestFirst) {
  const Field field(on_floor({{8.0, 5.0, 90.0}}));
  const auto& doorways = field.percept(1).doorways;
  ASSERT_EQ(doorways.size(), 3U);
  expect_near(doorways[0].offset_m, {1.0, 2.0});
  EXPECT_NEAR(std::abs(doorways[0].jamb_m.y()), 1.0, 1e-9);
  EXPECT_NEAR(doorways[0].jamb_m.x(), 0.0, 1e-9);
  expect_near(doorways[1].offset_m, {1.0, -5.5});
  EXPECT_NEAR(doorways[1].jamb_m.norm(), 0.5, 1e-9);
  expect_near(doorways[2].offset_m, {-1.0, -8.0});
  EXPECT_NEAR(doorways[2].jamb_m.norm(), 0.75, 1e-9);
}

TEST(Doorway, OutOfRangeOrBehindAWallIsNotSeen) {
  WorldConfig config = on_floor({{8.0, 5.0, 0.0}, {2.0, 2.0, 0.0}});
  config.operation.doorway_range_m = 3.0;
  const Field field(config);
  EXPECT_EQ(field.percept(1).doorways.size(), 1U);
  EXPECT_TRUE(field.percept(2).doorways.empty());
}

TEST(Doorway, ThatIsClosedIsNone) {
  WorldConfig config = on_floor({{8.0, 5.0, 0.0}});
  config.area.doors = "closed";
  EXPECT_EQ(Field(config).percept(1).doorways.size(), 1U);
}

TEST(Doorway, IsOneWhereADoorAndAGapAreTheSame) {
  const Field field(on_floor({{8.0, 5.0, 0.0}}, "GAP h 6 5.9 6 6.1 1\n"));
  EXPECT_EQ(field.percept(1).doorways.size(), 3U);
}

TEST(Doorway, LeadsIntoARoom) {
  const Field field(on_floor({{8.0, 5.0, 0.0}}, "GAP o 4 3.9 4 4.1 1\n"));
  EXPECT_EQ(field.percept(1).doorways.size(), 3U);
}

TEST(Doorway, ThatAreManyAreSeenAsFarAsAPerceptHolds) {
  std::string many = "WALL far 0 3 20 3\nROOM D 0 3 12 3 12 4 0 4\n";
  for (int i = 0; i < 19; ++i) {
    many += "DOOR m " + std::to_string(i) + ".4 3 " + std::to_string(i) + ".6 3\n";
  }
  const Field field(on_floor({{10.0, 2.0, 0.0}}, many));
  const auto& doorways = field.percept(1).doorways;
  ASSERT_EQ(doorways.size(), Percept::kMaxDoorways);
  EXPECT_TRUE(std::is_sorted(doorways.begin(), doorways.end(), [](const auto& a, const auto& b) {
    return a.offset_m.norm() < b.offset_m.norm() - 1e-9;
  }));
}

TEST(Mark, IsSeenByEverybodyUntilItIsTakenOff) {
  Field field(on_floor({{6.0, 5.0, 0.0}, {6.0, 8.0, 0.0}}));
  EXPECT_FALSE(field.percept(2).doorways.at(0).marked);
  field.step({acting(1, Act::Mark)});
  EXPECT_EQ(field.all<DoorwayMarked>(), (std::vector<DoorwayMarked>{{RobotId{1}, 1, true}}));
  EXPECT_TRUE(field.percept(1).deeds.marked);
  EXPECT_FALSE(field.percept(2).deeds.marked);
  EXPECT_TRUE(field.percept(1).doorways.at(0).marked);
  EXPECT_TRUE(field.percept(2).doorways.at(0).marked);
  field.step({acting(2, Act::Unmark)});
  EXPECT_EQ(field.all<DoorwayMarked>(), (std::vector<DoorwayMarked>{{RobotId{2}, 1, false}}));
  EXPECT_FALSE(field.percept(1).doorways.at(0).marked);
}

TEST(Mark, ThatIsThereAlreadyIsDoneWithoutAnEvent) {
  Field field(on_floor({{6.0, 5.0, 0.0}}));
  repeat(field, 2, {acting(1, Act::Mark)});
  EXPECT_TRUE(field.percept(1).deeds.marked);
  EXPECT_TRUE(field.all<DoorwayMarked>().empty());
}

TEST(Mark, NeedsADoorwayInReachAndInSight) {
  Field field(on_floor({{10.0, 5.0, 0.0}, {5.0, 3.5, 0.0}}));
  field.step({acting(1, Act::Mark), acting(2, Act::Mark)});
  EXPECT_TRUE(field.all<DoorwayMarked>().empty());
  EXPECT_FALSE(field.percept(1).deeds.marked);
}

TEST(Point, IsReachedOnceFromItsReach) {
  Field field(on_floor({{16.0, 5.0, 0.0}}));
  std::vector<PointReached> reached;
  double first_x_m = 0.0;
  for (int i = 0; i < 60; ++i) {
    const double direction = i < 30 ? 1.0 : -1.0;
    field.step({acting(1, Act::None, {direction, 0.0})});
    for (const PointReached& each : field.all<PointReached>()) {
      reached.push_back(each);
      first_x_m = field.place(1).x();
    }
  }
  EXPECT_EQ(reached, (std::vector<PointReached>{{RobotId{1}, 2}}));
  EXPECT_NEAR(first_x_m, 17.0, 0.11);
}

TEST(Point, UnderARobotAtTheStartIsReachedAtOnce) {
  Field field(on_floor({{2.0, 5.0, 0.0}}));
  field.step();
  EXPECT_EQ(field.all<PointReached>(), (std::vector<PointReached>{{RobotId{1}, 1}}));
}

}  // namespace
}  // namespace tacit
