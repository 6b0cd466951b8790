#include "console/debrief/warnings.h"

#include <gtest/gtest.h>

#include "tests/debrief/story.h"

namespace tacit {
namespace {

constexpr const char* kWarn = "Warn of each enemy";
constexpr const char* kHide = "Hide after each warning";
constexpr const char* kGoOn = "Go on when the hallway is clear";
constexpr std::uint16_t kSentry = 3;

/// Two robots in a hallway and a sentry.
Story pair() {
  Story story(kHouse, {.team = 2, .hostile = true});
  story.in_hallway(1).in_hallway(2);
  return story;
}

TEST(Warnings, AreNotWantedWhenNobodyIsSeen) {
  Story story = pair();
  story.says(2, "Enemy found.").seen(1, 2).seen(kSentry, 1);
  story.tell(RobotExposed{{1}, {kSentry}, false});
  for (const char* task : {kWarn, kHide, kGoOn}) {
    EXPECT_EQ(story.verdict(task), "not wanted") << task;
  }
}

TEST(Warnings, ComeAtMostTenSecondsBeforeOrAfter) {
  EXPECT_EQ(pair().at(500).seen(1, kSentry).at(600).says(2, "Enemy found.").verdict(kWarn), "done");
  EXPECT_EQ(pair().at(500).seen(1, kSentry).at(601).says(2, "Enemy found.").verdict(kWarn),
            "missing");
  const auto before = [](Tick seen) {
    Story story = pair();
    story.at(500).says(1, "Enemy found.").says(2, "Hallway clear.").at(seen).seen(2, kSentry);
    return story.verdict(kWarn);
  };
  EXPECT_EQ(before(600), "done");
  EXPECT_EQ(before(601), "missing");
}

TEST(Warnings, SayWhoWasSeenWhen) {
  EXPECT_EQ(pair().at(500).seen(1, kSentry).task(kWarn),
            (SubTask{kWarn, false,
                     "Robot 1 was seen by an enemy at tick 500 (50.0 s) without \"Enemy found.\" "
                     "at that time."}));
  EXPECT_EQ(pair().at(500).seen(2, kSentry).says(1, "Enemy found.").task(kWarn),
            (SubTask{kWarn, true,
                     "Robot 2 was seen by an enemy at tick 500 (50.0 s), the first of 1 times with "
                     "a warning."}));
}

TEST(Warnings, CountExposuresWithinThirtySecondsOnce) {
  Story story = pair();
  story.at(100).seen(1, kSentry).at(400).seen(2, kSentry).says(2, "Enemy found.");
  EXPECT_EQ(story.verdict(kWarn), "done");
  Story two = pair();
  two.at(100).seen(1, kSentry).at(401).seen(2, kSentry).says(2, "Enemy found.");
  EXPECT_EQ(two.verdict(kWarn), "missing");
}

TEST(Warnings, HoldUntilTheHallwayIsClear) {
  Story story = pair();
  story.at(100).seen(1, kSentry).says(2, "Enemy found.").at(2000).seen(2, kSentry);
  EXPECT_EQ(story.verdict(kWarn), "done");
  story.at(3000).says(2, "Hallway clear.").at(4000).seen(1, kSentry);
  EXPECT_EQ(story.verdict(kWarn), "missing");
}

TEST(Warnings, DoNotComeFromTheEnemy) {
  EXPECT_EQ(pair().seen(1, kSentry).says(kSentry, "Enemy found.").verdict(kWarn), "missing");
}

TEST(Hiding, NeedsAWarning) {
  EXPECT_EQ(pair().seen(1, kSentry).task(kHide),
            (SubTask{kHide, false, "Nobody said \"Enemy found.\"."}));
}

Story warned() {
  Story story = pair();
  story.at(100).seen(1, kSentry).says(2, "Enemy found.");
  return story;
}

TEST(Hiding, IsDoneWithinFortySeconds) {
  Story story = warned();
  story.at(300).enters(1, kEast).at(500).enters(2, kEast);
  EXPECT_EQ(story.task(kHide), (SubTask{kHide, true,
                                        "Robot 2 warned at tick 100 (10.0 s) for the last time, "
                                        "and nobody was late in hiding."}));
  Story late = warned();
  late.at(300).enters(1, kEast).at(501).enters(2, kEast);
  EXPECT_EQ(late.task(kHide), (SubTask{kHide, false,
                                       "Robot 2 was not in a room 40.0 s after the warning at tick "
                                       "100 (10.0 s)."}));
}

TEST(Hiding, IsMissingForARobotThatNeverHides) {
  Story story = warned();
  story.at(300).enters(2, kEast).at(501).tell(RunEnded{});
  EXPECT_EQ(story.verdict(kHide), "missing");
}

TEST(Hiding, IsDoneByARobotThatIsInARoomAlready) {
  Story story = pair();
  story.enters(1, kWest).enters(2, kEast).at(100).seen(1, kSentry).says(2, "Enemy found.");
  EXPECT_EQ(story.at(2000).tell(RunEnded{}).verdict(kHide), "done");
}

TEST(Hiding, IsWantedAfterEachWarning) {
  Story story = warned();
  story.enters(1, kEast).enters(2, kEast).at(900).in_hallway(1).in_hallway(2);
  story.says(2, "Enemy found.").at(1000).says(2, "Enemy found.").enters(2, kEast);
  EXPECT_EQ(story.at(1300).verdict(kHide), "done") << "the time is not over";
  EXPECT_EQ(story.at(1301).enters(1, kEast).verdict(kHide), "missing") << "40.1 s after the first";
}

TEST(Hiding, IsNotWantedAfterTheMission) {
  Story story = warned();
  story.at(200).tell(MissionOver{Verdict::Accomplished, 200}).at(2000).tell(RunEnded{});
  EXPECT_EQ(story.verdict(kHide), "done");
}

TEST(GoingOn, NeedsTheWordThatTheHallwayIsClear) {
  EXPECT_EQ(warned().in_hallway(1).task(kGoOn),
            (SubTask{kGoOn, false, "Nobody said \"Hallway clear.\"."}));
}

Story cleared() {
  Story story = warned();
  story.at(900).says(2, "Hallway clear.");
  return story;
}

TEST(GoingOn, IsAnythingThatTheFirstRobotDoesAfterThat) {
  EXPECT_EQ(
      cleared().task(kGoOn),
      (SubTask{kGoOn, false,
               "Robot 2 said \"Hallway clear.\" at tick 900 (90.0 s), but robot 1 did nothing "
               "after that."}));
  EXPECT_EQ(cleared().at(950).in_hallway(1).task(kGoOn),
            (SubTask{kGoOn, true,
                     "Robot 2 said \"Hallway clear.\" at tick 900 (90.0 s), and robot 1 went on at "
                     "tick 950 (95.0 s)."}));
  EXPECT_EQ(cleared().tests(1, 2).verdict(kGoOn), "done");
  EXPECT_EQ(cleared().says(1, "Follow me.").verdict(kGoOn), "done");
  EXPECT_EQ(cleared().tell(DoorwayMarked{{1}, 1, true}).verdict(kGoOn), "done");
  EXPECT_EQ(cleared().tell(MissionOver{Verdict::Accomplished, 900}).verdict(kGoOn), "done");
}

TEST(GoingOn, IsNothingElse) {
  Story story = cleared();
  story.in_hallway(2).tell(Collision{{1}, Obstruction::Wall, 1}).seen(1, kSentry);
  story.tell(MissionOver{Verdict::OutOfTime, 900});
  EXPECT_EQ(story.verdict(kGoOn), "missing");
}

TEST(GoingOn, IsWantedAfterTheLastTime) {
  Story story = cleared();
  story.in_hallway(1).at(2000).says(2, "Hallway clear.");
  EXPECT_EQ(story.verdict(kGoOn), "missing");
}

}  // namespace
}  // namespace tacit
