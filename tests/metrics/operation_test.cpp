#include "console/metrics/operation.h"

#include <gtest/gtest.h>

#include "console/metrics/tally.h"

namespace tacit {
namespace {

Tally tally_of(std::initializer_list<Happening> happenings) {
  Tally tally;
  for (const Happening& what : happenings) tally.add({7, what});
  return tally;
}

TEST(Operation, CountsWhatTheTeamDid) {
  const Tally tally = tally_of(
      {OperationBegun{2, 1}, SiteEntered{{1}, Site::Room, 1}, SiteEntered{{3}, Site::Room, 1},
       SiteEntered{{2}, Site::Hallway, 1}, ObjectTested{{1}, {4}, Finding::Dangerous},
       ObjectTested{{1}, {5}, Finding::Harmless}, ObjectStored{{2}, {6}, {7}},
       Signalled{{2}, Word("Cover me."), 1}, Alerted{{1}, Word("Found")},
       RobotExposed{{1}, {3}, true}, RobotExposed{{1}, {3}, false}, RobotFinished{{1}},
       RobotFinished{{3}}});
  EXPECT_EQ(tally.value("rooms_entered"), 1.0);
  EXPECT_EQ(tally.value("objects_tested"), 2.0);
  EXPECT_EQ(tally.value("objects_dangerous"), 1.0);
  EXPECT_EQ(tally.value("objects_stored"), 1.0);
  EXPECT_EQ(tally.value("signals"), 1.0);
  EXPECT_EQ(tally.value("alerts"), 1.0);
  EXPECT_EQ(tally.value("exposures"), 1.0);
  EXPECT_EQ(tally.value("robots_finished"), 1.0);
}

TEST(Operation, HasFailedUntilItIsAccomplished) {
  EXPECT_EQ(tally_of({OperationBegun{1, 0}}).value("failed"), 1.0);
  EXPECT_EQ(tally_of({OperationBegun{1, 0}, MissionOver{Verdict::TeamLost, 9}}).value("failed"),
            1.0);
  const Tally done = tally_of({OperationBegun{1, 0}, MissionOver{Verdict::Accomplished, 9}});
  EXPECT_EQ(done.value("failed"), 0.0);
  EXPECT_EQ(done.value("score_ticks"), 9.0);
}

TEST(Operation, HasNoMeasuresInOtherMissions) {
  EXPECT_EQ(tally_of({ForageBegun{3}, Alerted{{1}, Word("x")}}).value("alerts"), std::nullopt);
}

}  // namespace
}  // namespace tacit
