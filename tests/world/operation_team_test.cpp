#include <gtest/gtest.h>

#include "tests/world/operation_field.h"

namespace tacit {
namespace {

std::vector<std::string> heard(const Field& field, std::size_t robot) {
  std::vector<std::string> words;
  for (const Word& word : field.percept(robot).heard) {
    words.emplace_back(word.text());
  }
  return words;
}

using Texts = std::vector<std::string>;

TEST(Operation, BeginsWithItsRobots) {
  Field field(with_extras(on_floor({{2.0, 5.0, 0.0}, {4.0, 5.0, 0.0}, {8.0, 5.0, 0.0}}), 1));
  field.step();
  ASSERT_FALSE(field.told.empty());
  EXPECT_EQ(std::get<OperationBegun>(field.told[0].what), (OperationBegun{2, 1}));
  EXPECT_EQ(field.told[0].tick, 0U);
}

TEST(Signal, IsHeardInRangeInTheNextPerceptOnly) {
  WorldConfig config = on_floor({{2.0, 5.0, 0.0}, {6.0, 5.0, 0.0}, {12.0, 5.0, 0.0}});
  config.operation.signal.range_m = 5.0;
  Field field(config);
  field.step({saying(1, Act::Signal, "Cover me.")});
  EXPECT_EQ(heard(field, 2), (Texts{"Cover me."}));
  EXPECT_TRUE(heard(field, 1).empty());
  EXPECT_TRUE(heard(field, 3).empty());
  EXPECT_TRUE(field.percept(1).deeds.signalled);
  EXPECT_EQ(field.all<Signalled>(), (std::vector<Signalled>{{RobotId{1}, Word("Cover me."), 1}}));
  field.step();
  EXPECT_TRUE(heard(field, 2).empty());
}

TEST(Signal, OfSeveralIsHeardInOrderOfIdAndNoMoreThanAPerceptHolds) {
  Field field(on_floor({{2.0, 5.0, 0.0},
                        {3.0, 5.0, 0.0},
                        {4.0, 5.0, 0.0},
                        {5.0, 5.0, 0.0},
                        {6.0, 5.0, 0.0},
                        {7.0, 5.0, 0.0}}));
  std::vector<Command> commands;
  for (std::uint16_t i = 6; i >= 1; --i) {
    commands.push_back(saying(i, Act::Signal, std::to_string(i)));
  }
  field.step(commands);
  EXPECT_EQ(heard(field, 1), (Texts{"2", "3", "4", "5"}));
  EXPECT_EQ(heard(field, 6), (Texts{"1", "2", "3", "4"}));
  EXPECT_EQ(field.all<Signalled>().at(4).heard, 4U);
  EXPECT_EQ(field.all<Signalled>().at(5).heard, 0U);
}

TEST(Signal, GoesThroughWallsUnlessTheyBlockIt) {
  for (const bool blocked : {false, true}) {
    WorldConfig config = on_floor({{2.0, 5.0, 0.0}, {2.0, 8.0, 0.0}, {8.0, 5.0, 0.0}});
    config.operation.signal.blocked_by_walls = blocked;
    Field field(config);
    field.step({saying(1, Act::Signal, "a")});
    EXPECT_EQ(heard(field, 2).empty(), blocked);
    EXPECT_FALSE(heard(field, 3).empty());
  }
}

TEST(Signal, IsMissedAsOftenAsTheShareSays) {
  WorldConfig config = on_floor({{2.0, 5.0, 0.0}, {3.0, 5.0, 0.0}});
  config.operation.signal.missed_share = 0.3;
  Field field(config);
  int missed = 0;
  for (int i = 0; i < 1000; ++i) {
    field.step({saying(1, Act::Signal, "a")});
    missed += heard(field, 2).empty() ? 1 : 0;
    EXPECT_EQ(field.all<Signalled>().at(0).heard, heard(field, 2).size());
  }
  EXPECT_NEAR(missed, 300, 60);
}

TEST(Signal, IsMissedByOneWhateverElseWasSaid) {
  WorldConfig config = on_floor({{2.0, 5.0, 0.0}, {3.0, 5.0, 0.0}, {4.0, 5.0, 0.0}});
  config.operation.signal.missed_share = 0.5;
  Field quiet(config);
  Field loud(config);
  for (int i = 0; i < 50; ++i) {
    quiet.step({saying(1, Act::Signal, "a")});
    loud.step({saying(1, Act::Signal, "a"), saying(3, Act::Signal, "b")});
    const Texts words = heard(loud, 2);
    EXPECT_EQ(!heard(quiet, 2).empty(), std::find(words.begin(), words.end(), "a") != words.end());
  }
}

TEST(Alert, TellsTheOperator) {
  Field field(on_floor({{2.0, 5.0, 0.0}, {3.0, 5.0, 0.0}}));
  field.step({saying(2, Act::Alert, "Warning: Biohazard Found!!!")});
  EXPECT_EQ(field.all<Alerted>(),
            (std::vector<Alerted>{{RobotId{2}, Word("Warning: Biohazard Found!!!")}}));
  EXPECT_TRUE(field.percept(2).deeds.alerted);
  EXPECT_TRUE(heard(field, 1).empty());
}

TEST(Extras, ThatAreRedAreEnemiesToTheTeamAndSeeItBlue) {
  const Field field(with_extras(on_floor({{2.0, 5.0, 0.0}, {8.0, 5.0, 0.0}}), 1));
  EXPECT_TRUE(sees(field.percept(1), Kind::Enemy, Colour::Red));
  EXPECT_TRUE(sees(field.percept(2), Kind::Teammate, Colour::Blue));
  EXPECT_EQ(field.view.robots[1].colour, Colour::Red);
}

TEST(Extras, ThatAreBlueAreTeammates) {
  const Field field(with_extras(on_floor({{2.0, 5.0, 0.0}, {8.0, 5.0, 0.0}}), 1, "blue"));
  EXPECT_TRUE(sees(field.percept(1), Kind::Teammate, Colour::Blue));
}

TEST(Extras, AreHiddenByWalls) {
  const Field field(with_extras(on_floor({{2.0, 5.0, 0.0}, {2.0, 8.0, 0.0}}), 1));
  EXPECT_TRUE(field.percept(1).sightings.empty());
}

TEST(InterceptExtra, DisablesAnEnemyInReachForGood) {
  Field field(with_extras(on_floor({{2.0, 5.0, 0.0}, {2.9, 5.0, 0.0}, {4.0, 5.0, 0.0}}), 2));
  field.step({acting(1, Act::Intercept)});
  EXPECT_EQ(field.all<RobotDisabled>(), (std::vector<RobotDisabled>{{RobotId{2}, Mishap::Enemy}}));
  EXPECT_TRUE(field.percept(1).deeds.intercepted);
  EXPECT_FALSE(field.percept(2).able);
  EXPECT_TRUE(sees(field.percept(1), Kind::Enemy, Colour::Yellow));
  repeat(field, 20, {acting(2, Act::Intercept, {0.0, 0.5})});
  EXPECT_EQ(field.place(2), (WorldVec{2.9, 5.0}));
  EXPECT_TRUE(field.percept(1).able);
}

TEST(InterceptExtra, LaysDownWhatItHeld) {
  Field field(with_extras(
      on_floor({{2.0, 5.0, 0.0}, {2.9, 5.0, 0.0}}, "OBJECT 3.5 5 0.2 Movable brown\n"), 1));
  field.step({acting(2, Act::PickUp)});
  field.step({acting(1, Act::Intercept)});
  EXPECT_EQ(field.all<ObjectDropped>(),
            (std::vector<ObjectDropped>{{RobotId{2}, ObjectId{1}, {2.9, 5.0}}}));
  EXPECT_FALSE(field.percept(2).holding);
}

TEST(InterceptExtra, DoesNothingToFriendsOrThroughWalls) {
  Field friends(with_extras(on_floor({{2.0, 5.0, 0.0}, {2.9, 5.0, 0.0}}), 1, "blue"));
  friends.step({acting(1, Act::Intercept), acting(2, Act::Intercept)});
  EXPECT_TRUE(friends.all<RobotDisabled>().empty());
  Field apart(with_extras(on_floor({{2.0, 5.6, 0.0}, {2.0, 6.4, 0.0}}), 1));
  apart.step({acting(1, Act::Intercept)});
  EXPECT_TRUE(apart.all<RobotDisabled>().empty());
}

TEST(Exposure, BeginsAndEndsWithTheSightOfAnEnemy) {
  Field field(with_extras(on_floor({{6.0, 5.0, 90.0}, {18.0, 5.0, 0.0}}), 1));
  field.step();
  EXPECT_EQ(field.all<RobotExposed>(), (std::vector<RobotExposed>{{RobotId{1}, RobotId{2}, true}}));
  std::vector<RobotExposed> later;
  for (int i = 0; i < 30; ++i) {
    field.step({acting(1, Act::None, {1.0, 0.0})});
    for (const RobotExposed& each : field.all<RobotExposed>()) {
      later.push_back(each);
    }
  }
  EXPECT_EQ(later, (std::vector<RobotExposed>{{RobotId{1}, RobotId{2}, false}}));
}

TEST(Exposure, NeedsAnEnemyInRange) {
  WorldConfig config = with_extras(on_floor({{6.0, 5.0, 90.0}, {18.0, 5.0, 0.0}}), 1);
  config.operation.exposure_range_m = 11.9;
  Field far(config);
  far.step();
  EXPECT_TRUE(far.all<RobotExposed>().empty());
  Field friends(with_extras(on_floor({{6.0, 5.0, 90.0}, {18.0, 5.0, 0.0}}), 1, "blue"));
  friends.step();
  EXPECT_TRUE(friends.all<RobotExposed>().empty());
}

TEST(Exposure, EndsWhenTheEnemyIsDisabled) {
  Field field(with_extras(on_floor({{2.0, 5.0, 0.0}, {2.9, 5.0, 0.0}}), 1));
  field.step();
  field.step({acting(1, Act::Intercept)});
  EXPECT_EQ(field.all<RobotExposed>(),
            (std::vector<RobotExposed>{{RobotId{1}, RobotId{2}, false}}));
}

TEST(Finish, LetsARobotStandStillForGood) {
  Field field(on_floor({{2.0, 5.0, 0.0}, {4.0, 5.0, 0.0}}));
  field.step({acting(1, Act::Finish)});
  EXPECT_EQ(field.all<RobotFinished>(), (std::vector<RobotFinished>{{RobotId{1}}}));
  EXPECT_FALSE(field.world.over());
  repeat(field, 10, {acting(1, Act::Finish, {1.0, 0.0})});
  EXPECT_EQ(field.place(1), (WorldVec{2.0, 5.0}));
  EXPECT_TRUE(field.all<RobotFinished>().empty());
}

TEST(Finish, OfTheWholeTeamAccomplishesTheMission) {
  Field field(with_extras(on_floor({{2.0, 5.0, 0.0}, {4.0, 5.0, 0.0}, {8.0, 5.0, 0.0}}), 1));
  repeat(field, 3, {acting(1, Act::Finish)});
  field.step({acting(2, Act::Finish)});
  EXPECT_TRUE(field.world.over());
  EXPECT_EQ(std::get<MissionOver>(field.told.back().what), (MissionOver{Verdict::Accomplished, 4}));
}

TEST(FinishAll, FinishesTheTeamAtOnce) {
  Field field(with_extras(on_floor({{2.0, 5.0, 0.0}, {4.0, 5.0, 0.0}, {8.0, 5.0, 0.0}}), 1));
  field.step({acting(2, Act::FinishAll)});
  EXPECT_EQ(field.all<RobotFinished>(), (std::vector<RobotFinished>{{RobotId{1}}, {RobotId{2}}}));
  EXPECT_TRUE(field.world.over());
}

TEST(FinishAll, OfAnExtraRobotIsNotTheTeams) {
  Field field(with_extras(on_floor({{2.0, 5.0, 0.0}, {8.0, 5.0, 0.0}}), 1));
  field.step({acting(2, Act::FinishAll)});
  EXPECT_EQ(field.all<RobotFinished>(), (std::vector<RobotFinished>{{RobotId{2}}}));
  EXPECT_FALSE(field.world.over());
}

TEST(Operation, IsLostWithTheLastRobotOfTheTeam) {
  Field field(with_extras(on_floor({{2.0, 5.0, 0.0}, {2.9, 5.0, 0.0}}), 1));
  field.step({acting(2, Act::Intercept)});
  EXPECT_TRUE(field.world.over());
  EXPECT_EQ(std::get<MissionOver>(field.told.back().what), (MissionOver{Verdict::TeamLost, 1}));
}

TEST(Operation, IsAccomplishedWhenThoseThatCanHaveFinished) {
  Field field(with_extras(on_floor({{2.0, 5.0, 0.0}, {6.0, 5.0, 0.0}, {2.9, 5.0, 0.0}}), 1));
  field.step({acting(2, Act::Finish)});
  field.step({acting(3, Act::Intercept)});
  EXPECT_EQ(std::get<MissionOver>(field.told.back().what), (MissionOver{Verdict::Accomplished, 2}));
}

}  // namespace
}  // namespace tacit
