#include "console/debrief/cover.h"

#include <gtest/gtest.h>

#include "tests/debrief/story.h"

namespace tacit {
namespace {

constexpr const char* kAsk = "Ask for cover before each survey";
constexpr const char* kCover = "Cover each survey";
constexpr Debrief::Config kPair{.team = 2, .hostile = true};

Story pair_in_hallway(const Debrief::Config& config = kPair) {
  Story story(kHouse, config);
  story.in_hallway(1).in_hallway(2);
  return story;
}

TEST(Cover, IsNotWantedWithoutAnEnemyOrAlone) {
  EXPECT_EQ(pair_in_hallway({.team = 2}).verdict(kAsk), "not wanted");
  EXPECT_EQ(pair_in_hallway({.team = 1, .hostile = true}).verdict(kCover), "not wanted");
}

TEST(Cover, IsMissingWithoutASurvey) {
  EXPECT_EQ(pair_in_hallway().task(kAsk), (SubTask{kAsk, false, "Robot 1 surveyed no room."}));
  EXPECT_EQ(pair_in_hallway().task(kCover), (SubTask{kCover, false, "Robot 1 surveyed no room."}));
}

TEST(Cover, IsAskedForBeforeEachRoom) {
  Story story = pair_in_hallway();
  story.says(1, "Cover me.").at(100).enters(1, kEast);
  EXPECT_EQ(story.task(kAsk), (SubTask{kAsk, true,
                                       "\"Cover me.\" came before each of 1 surveys; the first: "
                                       "Robot 1 entered East at tick 100 (10.0 s)."}));
  story.at(200).in_hallway(1).at(300).enters(1, kWest);
  EXPECT_EQ(story.task(kAsk), (SubTask{kAsk, false,
                                       "Robot 1 entered West at tick 300 (30.0 s) without "
                                       "\"Cover me.\" before."}));
}

TEST(Cover, MustBeAskedForByTheFirstRobotOutsideOfRooms) {
  EXPECT_EQ(pair_in_hallway().says(2, "Cover me.").enters(1, kEast).verdict(kAsk), "missing");
  Story story = pair_in_hallway();
  story.says(1, "Cover me.").enters(1, kEast).says(1, "Cover me.");
  story.in_hallway(1).enters(1, kWest);
  EXPECT_EQ(story.verdict(kAsk), "missing");
}

TEST(Cover, IsAskedForOncePerRoom) {
  Story story = pair_in_hallway();
  story.says(1, "Cover me.").enters(1, kEast).in_hallway(1).enters(1, kEast);
  EXPECT_EQ(story.verdict(kAsk), "done") << "it stepped back over the threshold";
}

TEST(Cover, NeedNotBeAskedForInFlight) {
  Story story = pair_in_hallway();
  story.says(1, "Cover me.").enters(1, kEast).in_hallway(1);
  story.says(2, "Enemy found.").enters(1, kWest);
  EXPECT_EQ(story.verdict(kAsk), "done");
}

/// The warning comes between the call for cover and the entry into the room.
Story warned_on_the_doorstep() {
  Story story(kHouse + kSuspects, kPair);
  story.in_hallway(1).in_hallway(2).says(1, "Cover me.").says(2, "Enemy found.");
  story.at(100).enters(1, kWest);
  return story;
}

TEST(Cover, TakesARoomThatItAskedForAndWorksInForSurveyedThoughItWasWarned) {
  Story story = warned_on_the_doorstep();
  EXPECT_EQ(story.verdict(kAsk), "missing") << "so far it hides";
  story.at(200).tests(1, 2);
  EXPECT_EQ(story.verdict(kAsk), "done");
  EXPECT_EQ(story.verdict(kCover), "done");
}

TEST(Cover, TakesARefugeThatItDidNotAskForForNoSurvey) {
  Story story(kHouse + kSuspects, kPair);
  story.in_hallway(1).in_hallway(2).says(2, "Enemy found.").enters(1, kWest).tests(1, 2);
  EXPECT_EQ(story.verdict(kAsk), "missing");
}

TEST(Cover, IsNeededInARefugeThatIsSurveyedOnceTheHallwayIsClear) {
  Story story = warned_on_the_doorstep();
  story.tests(1, 2).at(200).enters(2, kWest).says(2, "Hallway clear.").at(251).in_hallway(1);
  EXPECT_EQ(story.verdict(kCover), "missing");
}

TEST(Cover, ComesFromTheHallwayOrAnotherRoom) {
  Story story = pair_in_hallway();
  story.enters(1, kEast).at(500).in_hallway(1).at(501);
  EXPECT_EQ(story.task(kCover),
            (SubTask{kCover, true,
                     "Robot 1 entered East at tick 0 (0.0 s) and was without cover there for 0.0 s "
                     "at most."}));
  story.enters(2, kWest).enters(1, kEast).at(900).in_hallway(1);
  EXPECT_EQ(story.verdict(kCover), "done");
}

TEST(Cover, DoesNotComeFromTheSameRoomOrTheOpen) {
  Story same = pair_in_hallway();
  same.at(100).enters(1, kEast).enters(2, kEast).at(251).in_hallway(1);
  EXPECT_EQ(same.task(kCover),
            (SubTask{kCover, false,
                     "Robot 1 entered East at tick 100 (10.0 s) and was without cover there for "
                     "15.1 s."}));
  Story open = pair_in_hallway();
  open.tell(SiteEntered{{2}, Site::Open, 0}).enters(1, kEast).at(51).in_hallway(1);
  EXPECT_EQ(open.verdict(kCover), "missing");
}

TEST(Cover, DoesNotComeFromAnExtraRobot) {
  Story story(kHouse, kPair);
  story.in_hallway(3).enters(2, kEast).enters(1, kEast).at(51).in_hallway(1);
  EXPECT_EQ(story.verdict(kCover), "missing");
}

TEST(Cover, MayBeShortForFiveSecondsInAll) {
  Story story = pair_in_hallway();
  story.enters(2, kEast).enters(1, kEast).at(30).in_hallway(2);
  story.at(100).enters(2, kEast).at(120).in_hallway(2).at(200);
  EXPECT_EQ(story.verdict(kCover), "done") << "3 s and 2 s";
  story.enters(2, kEast).at(201).in_hallway(2);
  EXPECT_EQ(story.verdict(kCover), "missing");
}

TEST(Cover, IsNotNeededAsLongAsTheTeamHides) {
  Story story = pair_in_hallway();
  story.enters(1, kEast).at(10).says(2, "Enemy found.").enters(2, kEast).at(900);
  story.in_hallway(2).says(2, "Hallway clear.").at(990).in_hallway(1);
  EXPECT_EQ(story.verdict(kCover), "done");
}

TEST(Cover, IsNotNeededAfterTheMission) {
  Story story = pair_in_hallway();
  story.enters(1, kEast).at(10).tell(MissionOver{Verdict::Accomplished, 10}).enters(2, kEast);
  story.at(900).in_hallway(1);
  EXPECT_EQ(story.verdict(kCover), "done");
}

}  // namespace
}  // namespace tacit
