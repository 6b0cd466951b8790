#include "console/debrief/debrief.h"

#include <gtest/gtest.h>

#include "tests/debrief/story.h"
#include "tests/wire/words.h"

namespace tacit {
namespace {

const std::string kWay =
    "MISSION-AREA 50 50\nPP \"StartPlace*\" 1 1 0.2\nPP \"Way1\" 5 5 1\nPP \"entry\" 9 9\n"
    "PP \"APPROACH north*\" 20 20\nPP \"Midway\" 30 30\n";

TEST(WayPoints, AreReachedByARobotOfTheTeam) {
  Story story(kWay, {.team = 2});
  story.at(20).tell(PointReached{{1}, 1}).tell(PointReached{{3}, 3});
  story.at(31).tell(PointReached{{2}, 2}).at(40).tell(PointReached{{1}, 2});
  EXPECT_EQ(story.task("Reach Way1"),
            (SubTask{"Reach Way1", true, "Robot 2 was there at tick 31 (3.1 s)."}));
  EXPECT_EQ(story.task("Reach entry"),
            (SubTask{"Reach entry", false, "No robot of the team was there."}));
  EXPECT_EQ(story.verdict("Reach APPROACH north"), "missing");
  EXPECT_EQ(story.verdict("Reach StartPlace"), "not wanted");
  EXPECT_EQ(story.verdict("Reach Midway"), "not wanted");
}

TEST(MinesToStore, AreEachPutIntoAContainer) {
  Story story(
      "MISSION-AREA 50 50\nOBJECT 40 31 2 CONTAINER \"green\"\nOBJECT 12 18 0.4 MOVABLE "
      "\"Orange\"\n"
      "OBJECT 18 31 0.4 MOVABLE orange\nOBJECT 20 31 0.4 FIXED orange\n");
  story.at(80).tell(ObjectStored{{1}, {3}, {1}}).tell(ObjectDropped{{1}, {2}, {3.0, 4.0}});
  EXPECT_EQ(story.task("Store the mine that is object 3"),
            (SubTask{"Store the mine that is object 3", true,
                     "Robot 1 put it into a container at tick 80 (8.0 s)."}));
  EXPECT_EQ(story.task("Store the mine that is object 2"),
            (SubTask{"Store the mine that is object 2", false, "Nobody put it into a container."}));
  EXPECT_EQ(story.verdict("Store the mine that is object 4"), "not wanted");
}

std::optional<SubTask> ended(std::optional<Verdict> verdict) {
  Story story(kWay);
  story.at(1234);
  if (verdict) story.tell(MissionOver{*verdict, 1234});
  return story.at(2000).tell(RunEnded{}).task("Accomplish the mission");
}

TEST(Debrief, WantsTheMissionAccomplished) {
  const std::string name = "Accomplish the mission";
  EXPECT_EQ(ended(Verdict::Accomplished),
            (SubTask{name, true, "Every robot had nothing more to do at tick 1234 (123.4 s)."}));
  EXPECT_EQ(ended(Verdict::TeamLost),
            (SubTask{name, false, "Every robot was disabled at tick 1234 (123.4 s)."}));
  EXPECT_EQ(ended(Verdict::OutOfTime),
            (SubTask{name, false, "The time ran out at tick 1234 (123.4 s)."}));
  EXPECT_EQ(ended(std::nullopt), (SubTask{name, false, "It did not come to an end."}));
}

TEST(Debrief, ScoresWhatIsDoneOfWhatIsWanted) {
  Story story(kWay);
  story.tell(PointReached{{1}, 3}).tell(MissionOver{Verdict::Accomplished, 0});
  const Checklist list = story.list();
  EXPECT_EQ(list.done(), 2U);
  EXPECT_EQ(list.wanted(), 4U);
  EXPECT_EQ(list.score(), 0.5);
  EXPECT_EQ(Checklist{}.score(), 1.0);
}

TEST(Debrief, CountsSecondsByTheLengthOfATick) {
  Story story(kWay, {.tick_s = 0.5});
  story.at(31).tell(PointReached{{1}, 2});
  EXPECT_EQ(story.task("Reach Way1")->evidence, "Robot 1 was there at tick 31 (15.5 s).");
}

/// A pair that does everything as it should be.
Story good_pair() {
  Story story(kHouse + kSuspects + kWay.substr(kWay.find("PP")), {.team = 2, .hostile = true});
  story.tell(PointReached{{1}, 2}).tell(PointReached{{1}, 3}).tell(PointReached{{2}, 4});
  story.at(10).in_hallway(1).in_hallway(2).at(100).says(1, "Cover me.").enters(1, kWest);
  story.at(200).tests(1, 2).at(300).in_hallway(1).says(1, "Follow me.");
  story.at(400).seen(2, 3).says(2, "Enemy found.").at(500).enters(1, kWest).enters(2, kEast);
  story.at(900).in_hallway(2).says(2, "Hallway clear.").at(950).in_hallway(1);
  story.at(1000).says(1, "Cover me.").enters(1, kEast).tests(1, 3, Finding::Dangerous);
  story.at(1100).alerts(1).tell(MissionOver{Verdict::Accomplished, 1100});
  return story;
}

TEST(Debrief, FindsNothingMissingWhenAllIsDone) {
  for (const SubTask& task : good_pair().list().tasks) {
    EXPECT_TRUE(task.done) << task.name << ": " << task.evidence;
  }
  EXPECT_EQ(good_pair().list().wanted(), 15U);
}

TEST(Debrief, TakesEventsThatTheMapDoesNotExplain) {
  test::Words words(11);
  Story story(kHouse + kSuspects + kWay.substr(kWay.find("PP")), {.team = 3, .hostile = true});
  const std::size_t wanted = story.list().wanted();
  for (int i = 0; i < 40; ++i) {
    for (const Event& event : words.batch().events) story.at(event.tick).tell(event.what);
  }
  EXPECT_GE(story.list().wanted(), wanted);
  story.at(0).tell(SiteEntered{{1}, Site::Room, 4'000'000'000});
  story.tell(SiteEntered{{1}, Site::Room, 0}).tests(1, 0).tell(PointReached{{0}, 0});
  EXPECT_GE(story.list().wanted(), wanted);
}

}  // namespace
}  // namespace tacit
