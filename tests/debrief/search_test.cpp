#include "console/debrief/search.h"

#include <gtest/gtest.h>

#include "tests/debrief/story.h"

namespace tacit {
namespace {

constexpr const char* kAlert = "Alert on the real object and on nothing else";
const std::string kSearched = kHouse + kSuspects;

TEST(Search, WantsTheHallwayEntered) {
  Story story(kSearched);
  EXPECT_EQ(story.verdict("Enter the hallway"), "missing");
  story.at(12).in_hallway(1);
  EXPECT_EQ(story.task("Enter the hallway"),
            (SubTask{"Enter the hallway", true, "Robot 1 was in it at tick 12 (1.2 s)."}));
}

TEST(Search, WantsNoHallwayWhereThereIsNone) {
  EXPECT_EQ(Story("MISSION-AREA 9 9\n" + kSuspects).verdict("Enter the hallway"), "not wanted");
}

TEST(Search, WantsEachRoomWithAWayInEntered) {
  Story story(kSearched);
  story.at(40).enters(1, kWest);
  EXPECT_EQ(story.task("Enter West"),
            (SubTask{"Enter West", true, "Robot 1 entered at tick 40 (4.0 s)."}));
  EXPECT_EQ(story.task("Enter East"),
            (SubTask{"Enter East", false, "No robot of the team entered."}));
  EXPECT_EQ(story.verdict("Enter Shut"), "not wanted");
}

TEST(Search, CountsNoExtraRobot) {
  Story story(kSearched, {.team = 1});
  story.enters(2, kWest).in_hallway(2).tests(2, 3, Finding::Dangerous).alerts(2);
  EXPECT_EQ(story.verdict("Enter West"), "missing");
  EXPECT_EQ(story.verdict("Enter the hallway"), "missing");
  EXPECT_EQ(story.verdict("Test object 3 in East once"), "not wanted");
  EXPECT_EQ(story.verdict(kAlert), "missing");
}

TEST(Search, WantsNoRoomOfABuildingThatIsButALandmark) {
  const std::string hut = "MISSION-AREA 9 9\nROOM hut 2 2 8 2 8 8 2 8\nDOOR d 4 8 5 8\n";
  EXPECT_EQ(Story(hut).verdict("Enter hut"), "not wanted");
  EXPECT_EQ(Story(hut + "OBJECT 3 3 0.5 FIXED brown\n").verdict("Enter hut"), "missing");
}

TEST(Search, NeedsNoMoreRoomsOnceItHasAlertedOnTheRealObject) {
  Story story(kSearched);
  story.enters(1, kEast).tests(1, 3, Finding::Dangerous);
  EXPECT_EQ(story.verdict("Enter West"), "missing");
  story.alerts(1);
  EXPECT_EQ(story.verdict("Enter West"), "not wanted");
  EXPECT_EQ(story.verdict("Enter East"), "done");
}

TEST(Search, WantsASuspectInAnEnteredRoomTestedOnce) {
  const std::string task = "Test object 2 in West once";
  Story story(kSearched);
  EXPECT_EQ(story.verdict(task), "not wanted");
  story.enters(1, kWest);
  EXPECT_EQ(story.task(task), (SubTask{task, false, "Nobody tested it."}));
  story.at(50).tests(1, 2);
  EXPECT_EQ(story.task(task),
            (SubTask{task, true, "Robot 1 found it harmless at tick 50 (5.0 s)."}));
  story.at(60).tests(1, 2);
  EXPECT_EQ(story.task(task),
            (SubTask{task, false,
                     "Robot 1 found it harmless at tick 60 (6.0 s), which was test 2 of it."}));
}

TEST(Search, WantsASuspectOutsideAllRoomsTestedUnlessTheRealOneIsFoundBefore) {
  Story story(kSearched + "OBJECT 20 10 0.5 FIXED brown\n");
  EXPECT_EQ(story.verdict("Test object 5 once"), "missing");
  story.tests(1, 3, Finding::Dangerous).alerts(1);
  EXPECT_EQ(story.verdict("Test object 5 once"), "not wanted");
}

TEST(Search, WantsASuspectThatWasPassedByBeforeTheRealOneWasFound) {
  Story story(kSearched);
  story.enters(1, kWest).enters(1, kEast).tests(1, 3, Finding::Dangerous).alerts(1);
  EXPECT_EQ(story.verdict("Test object 2 in West once"), "missing");
}

TEST(Search, NeedsNoOtherSuspectInTheRealOnesRoom) {
  const std::string task = "Test object 5 in East once";
  Story story(kSearched + "OBJECT 35 3 0.5 FIXED brown\n");
  story.enters(1, kEast).tests(1, 3, Finding::Dangerous);
  EXPECT_EQ(story.verdict(task), "missing");
  story.alerts(1);
  EXPECT_EQ(story.verdict(task), "not wanted");
}

TEST(Search, DoesNotTakeARefugeForALookedAtRoom) {
  Story story(kSearched, {.team = 2});
  story.says(2, "Enemy found.").enters(1, kWest).says(2, "Hallway clear.");
  story.enters(1, kEast).tests(1, 3, Finding::Dangerous).alerts(1);
  EXPECT_EQ(story.verdict("Enter West"), "not wanted");
  EXPECT_EQ(story.verdict("Test object 2 in West once"), "not wanted");
  EXPECT_EQ(story.verdict("Enter East"), "done");
}

TEST(Search, WantsAnAlertAfterTheRealObjectWasFound) {
  Story story(kSearched);
  EXPECT_EQ(story.task(kAlert), (SubTask{kAlert, false, "Nobody found it."}));
  story.at(70).tests(1, 3, Finding::Dangerous);
  EXPECT_EQ(story.task(kAlert),
            (SubTask{kAlert, false,
                     "Robot 1 found it at tick 70 (7.0 s), but nobody alerted after that."}));
  story.at(71).alerts(1);
  EXPECT_EQ(story.task(kAlert),
            (SubTask{kAlert, true,
                     "Robot 1 alerted at tick 71 (7.1 s), after robot 1 had found it at tick 70 "
                     "(7.0 s)."}));
}

TEST(Search, TakesNoAlertBeforeThat) {
  Story story(kSearched);
  story.at(5).tests(1, 2).alerts(1).at(9).tests(1, 3, Finding::Dangerous).alerts(1);
  EXPECT_EQ(story.task(kAlert),
            (SubTask{kAlert, false,
                     "Robot 1 alerted at tick 5 (0.5 s) without the real object having been "
                     "found."}));
}

TEST(Search, TakesNoOtherDangerousObjectForTheRealOne) {
  Story story(kSearched);
  story.tests(1, 2, Finding::Dangerous).alerts(1);
  EXPECT_EQ(story.verdict(kAlert), "missing");
}

TEST(Search, WantsNoAlertWhereNothingIsReal) {
  Story story(kHouse + "OBJECT 3 3 0.5 FIXED brown\n");
  EXPECT_EQ(story.task("Alert on nothing"),
            (SubTask{"Alert on nothing", true, "There was no alert."}));
  story.alerts(1);
  EXPECT_EQ(story.task("Alert on nothing"),
            (SubTask{"Alert on nothing", false,
                     "Robot 1 alerted at tick 0 (0.0 s) where no object is real."}));
}

TEST(Search, TakesAnAlertForAReportWhereNothingIsSuspect) {
  Story story(kHouse);
  story.alerts(1);
  EXPECT_EQ(story.verdict("Alert on nothing"), "not wanted");
  EXPECT_EQ(story.verdict(kAlert), "not wanted");
}

}  // namespace
}  // namespace tacit
