#include <gtest/gtest.h>

#include "tests/world/forage_field.h"

namespace tacit {
namespace {

using Places = std::vector<std::vector<double>>;

// Robot 1 stands at (22, 20), robot 2 at (18, 20).
WorldConfig with_mines(const Places& places, std::int64_t robots = 2) {
  WorldConfig config = bare_field(robots);
  config.forage.mines.places = places;
  return config;
}

// Robot 1 stands within reach of the base and holds the only mine but one.
Field with_a_mine_at_the_base(double ring_radius_m = 0.5) {
  WorldConfig config = with_mines({{20.0 + ring_radius_m, 20.0}, {3.0, 3.0}}, 1);
  config.robots.ring_radius_m = ring_radius_m;
  Field field(config);
  field.step({acting(1, Act::PickUp)});
  return field;
}

TEST(PickUp, TakesTheNearestMine) {
  Field field(with_mines({{22.4, 20.0}, {22.0, 20.3}, {3.0, 3.0}}));
  field.step({acting(1, Act::PickUp)});
  EXPECT_EQ(field.all<MineTaken>(), (std::vector<MineTaken>{{RobotId{1}, MineId{2}}}));
  EXPECT_TRUE(field.percept(1).holding);
  EXPECT_TRUE(field.percept(1).deeds.picked_up);
  EXPECT_TRUE(field.view.robots[0].holding);
}

TEST(PickUp, TakesTheLowestNumberOfEquallyNearMines) {
  Field field(with_mines({{22.0, 20.25}, {22.25, 20.0}, {22.0, 19.75}}));
  field.step({acting(1, Act::PickUp)});
  EXPECT_EQ(field.all<MineTaken>(), (std::vector<MineTaken>{{RobotId{1}, MineId{1}}}));
}

TEST(PickUp, ReachesAsFarAsItsReachAndNoFurther) {
  for (const double away_m : {0.5, 0.51}) {
    Field field(with_mines({{22.0 + away_m, 20.0}}));
    field.step({acting(1, Act::PickUp)});
    EXPECT_EQ(field.percept(1).holding, away_m <= 0.5);
  }
}

TEST(PickUp, HappensAfterTheMotionOfTheStep) {
  Field field(with_mines({{22.6, 20.0}}));
  field.step({acting(1, Act::PickUp, {0.2, 0.0})});
  EXPECT_TRUE(field.percept(1).holding);
}

TEST(PickUp, NeedsTheAct) {
  Field field(with_mines({{22.1, 20.0}}));
  for (const Act act : {Act::None, Act::Drop, Act::Intercept, Act::Aid}) {
    field.step({acting(1, act)});
    EXPECT_TRUE(field.told.empty());
  }
}

TEST(PickUp, ServesRobotsInOrderOfId) {
  WorldConfig config = with_mines({{20.0, 20.0}});
  config.robots.ring_radius_m = 0.3;
  Field field(config);
  field.step({acting(2, Act::PickUp), acting(1, Act::PickUp)});
  EXPECT_EQ(field.all<MineTaken>(), (std::vector<MineTaken>{{RobotId{1}, MineId{1}}}));
  EXPECT_FALSE(field.percept(2).holding);
}

TEST(PickUp, TakesNoSecondMine) {
  Field field(with_mines({{22.1, 20.0}, {22.2, 20.0}}));
  field.step({acting(1, Act::PickUp)});
  field.step({acting(1, Act::PickUp)});
  EXPECT_TRUE(field.told.empty());
  EXPECT_TRUE(field.percept(1).holding);
  EXPECT_FALSE(field.percept(1).deeds.picked_up);
}

TEST(Mines, ThatAreHeldAreNeitherSeenNorShown) {
  Field field(with_mines({{22.1, 20.0}, {3.0, 3.0}}));
  EXPECT_EQ(seen(field.percept(2), Kind::Mine, Colour::Orange), 2);
  EXPECT_EQ(field.view.mines.size(), 2u);
  field.step({acting(1, Act::PickUp)});
  EXPECT_EQ(seen(field.percept(2), Kind::Mine, Colour::Orange), 1);
  ASSERT_EQ(field.view.mines.size(), 1u);
  EXPECT_EQ(field.view.mines[0].mine, MineId{2});
}

TEST(Drop, LaysTheMineWhereTheRobotStands) {
  Field field(with_mines({{22.1, 20.0}}));
  field.step({acting(1, Act::PickUp)});
  field.step({acting(1, Act::Drop, {0.2, 0.0})});
  EXPECT_EQ(field.all<MineDropped>(),
            (std::vector<MineDropped>{{RobotId{1}, MineId{1}, field.place(1)}}));
  EXPECT_TRUE(field.percept(1).deeds.dropped);
  EXPECT_FALSE(field.percept(1).deeds.stored);
  EXPECT_FALSE(field.percept(1).holding);
  ASSERT_EQ(field.view.mines.size(), 1u);
  EXPECT_EQ(field.view.mines[0].position_m, field.place(1));
}

TEST(Drop, StoresAMineAtTheBaseAndTellsHowManyAreLeft) {
  Field field = with_a_mine_at_the_base();
  field.step({acting(1, Act::Drop)});
  EXPECT_EQ(field.all<MineStored>(), (std::vector<MineStored>{{RobotId{1}, MineId{1}, 1}}));
  EXPECT_TRUE(field.percept(1).deeds.stored);
  EXPECT_FALSE(field.percept(1).deeds.dropped);
  EXPECT_FALSE(field.percept(1).holding);
  EXPECT_EQ(field.view.mines.size(), 1u);
}

TEST(Drop, StoresAsFarFromTheBaseAsItsReachAndNoFurther) {
  for (const double away_m : {1.0, 1.01}) {
    Field field = with_a_mine_at_the_base(away_m);
    field.step({acting(1, Act::Drop)});
    EXPECT_EQ(field.all<MineStored>().size(), away_m <= 1.0 ? 1u : 0u);
    EXPECT_EQ(field.all<MineDropped>().size(), away_m <= 1.0 ? 0u : 1u);
  }
}

TEST(Drop, OfNothingIsNothing) {
  Field field(with_mines({{22.1, 20.0}}));
  field.step({acting(1, Act::Drop)});
  EXPECT_TRUE(field.told.empty());
}

TEST(Drop, ThatLaysAMineLetsItBeTakenAgain) {
  Field field(with_mines({{22.1, 20.0}}));
  field.step({acting(1, Act::PickUp)});
  field.step({acting(1, Act::Drop)});
  field.step({acting(1, Act::PickUp)});
  EXPECT_EQ(field.all<MineTaken>().size(), 1u);
}

TEST(Deeds, LastForOneStep) {
  Field field(with_mines({{22.1, 20.0}}));
  field.step({acting(1, Act::PickUp)});
  field.step();
  EXPECT_EQ(field.percept(1).deeds, Deeds{});
}

TEST(ForageMission, IsAccomplishedWithTheLastMine) {
  WorldConfig config = with_mines({{20.4, 20.0}}, 1);
  config.robots.ring_radius_m = 0.5;
  Field field(config);
  field.step({acting(1, Act::PickUp)});
  EXPECT_FALSE(field.world.over());
  field.step({acting(1, Act::Drop)});
  EXPECT_TRUE(field.world.over());
  EXPECT_EQ(field.told.back(), (Event{2, MissionOver{Verdict::Accomplished, 2}}));
}

TEST(ForageMission, IsOutOfTimeAtTheCap) {
  WorldConfig config = bare_field(1);
  config.forage.cap_ticks = 3;
  config.physics.checkpoint_ticks = 3;
  Field field(config);
  field.step();
  field.step();
  EXPECT_FALSE(field.world.over());
  field.step();
  EXPECT_TRUE(field.world.over());
  ASSERT_EQ(field.told.size(), 2u);
  EXPECT_TRUE(std::holds_alternative<Checkpoint>(field.told[0].what));
  EXPECT_EQ(field.told[1], (Event{3, MissionOver{Verdict::OutOfTime, 3}}));
}

TEST(ForageMission, WithTheLastMineAtTheCapIsAccomplished) {
  WorldConfig config = with_mines({{20.4, 20.0}}, 1);
  config.robots.ring_radius_m = 0.5;
  config.forage.cap_ticks = 2;
  Field field(config);
  field.step({acting(1, Act::PickUp)});
  field.step({acting(1, Act::Drop)});
  EXPECT_EQ(field.all<MissionOver>(), (std::vector<MissionOver>{{Verdict::Accomplished, 2}}));
}

TEST(ForageMissionDeathTest, CannotBeSteppedBeyondItsEnd) {
  WorldConfig config = bare_field(1);
  config.forage.cap_ticks = 1;
  Field field(config);
  field.step();
  EXPECT_DEATH(field.step(), "over");
}

TEST(GuardMission, IsNeverOver) {
  World world(busy_world(2), 1);
  for (Tick tick = 0; tick < 300; ++tick) {
    world.step({});
    ASSERT_FALSE(world.over());
  }
}

TEST(Base, IsSeenAndPurple) {
  const Field field(bare_field(1));
  ASSERT_EQ(seen(field.percept(1), Kind::Base, Colour::Purple), 1);
  const auto& sightings = field.percept(1).sightings;
  const auto base = std::find_if(sightings.begin(), sightings.end(),
                                 [](const Sighting& s) { return s.kind == Kind::Base; });
  // The robot faces away from it.
  EXPECT_NEAR(base->offset_m.x(), -2.0, 1e-12);
  EXPECT_NEAR(base->radius_m, 0.5, 0.0);
  EXPECT_EQ(seen(field.percept(1), Kind::Target, Colour::White), 0);
}

TEST(Mines, AreSeenWithinRangeFieldOfViewAndLineOfSight) {
  const Places places{{32.0, 20.0}, {12.0, 20.0}};
  const auto mines_seen = [](const WorldConfig& config) {
    return seen(Field(config).percept(1), Kind::Mine, Colour::Orange);
  };
  WorldConfig config = with_mines(places, 1);
  EXPECT_EQ(mines_seen(config), 2);
  config.sight.range_m = 9.0;
  EXPECT_EQ(mines_seen(config), 0);
  config = with_mines(places, 1);
  config.sight.field_of_view_deg = 90.0;
  EXPECT_EQ(mines_seen(config), 1);
  config = with_mines(places, 1);
  config.obstacles.discs = {{27.0, 20.0, 1.0}};
  EXPECT_EQ(mines_seen(config), 1);
}

TEST(Mines, BeyondWhatASensorHoldsAreDroppedFarthestFirst) {
  WorldConfig config = bare_field(1);
  config.forage.mines.count = 300;
  const Field field(config);
  const auto& sightings = field.percept(1).sightings;
  ASSERT_EQ(sightings.size(), Percept::kMaxSightings);
  double farthest = 0.0;
  for (const Sighting& s : sightings) {
    farthest = std::max(farthest, s.offset_m.norm());
  }
  std::ptrdiff_t nearer = 1;  // The base.
  for (const ViewedMine& mine : field.view.mines) {
    nearer += static_cast<std::ptrdiff_t>((mine.position_m - field.place(1)).norm() <= farthest);
  }
  EXPECT_EQ(nearer, static_cast<std::ptrdiff_t>(Percept::kMaxSightings));
}

TEST(ForageCheckpoint, MeasuresTheDistanceToTheBase) {
  WorldConfig config = bare_field(2);
  config.physics.checkpoint_ticks = 1;
  Field field(config);
  field.step();
  const auto checkpoints = field.all<Checkpoint>();
  ASSERT_EQ(checkpoints.size(), 1u);
  EXPECT_NEAR(checkpoints[0].mean_distance_to_target_m, 2.0, 1e-12);
  EXPECT_EQ(checkpoints[0].enemies, 0u);
}

TEST(ForageDigest, CoversWhoHoldsAMine) {
  Field held(with_mines({{22.1, 20.0}}));
  Field lying(with_mines({{22.1, 20.0}}));
  held.step({acting(1, Act::PickUp)});
  lying.step({acting(2, Act::PickUp)});
  EXPECT_NE(held.world.digest(), lying.world.digest());
}

TEST(ForageDigest, CoversWhereAMineLies) {
  EXPECT_NE(World(with_mines({{5.0, 5.0}}), 1).digest(),
            World(with_mines({{5.0, 6.0}}), 1).digest());
}

TEST(ForageMission, BeginsOnceWithTheNumberOfItsMines) {
  WorldConfig config = bare_field(1);
  config.forage.mines.count = 4;
  Field field(config);
  for (int i = 0; i < 5; ++i) {
    field.step();
  }
  EXPECT_EQ(field.begun, std::vector<ForageBegun>{ForageBegun{5}});
}

}  // namespace
}  // namespace tacit
