#include "console/report/progress_text.h"

#include <gtest/gtest.h>

#include <initializer_list>

namespace tacit {
namespace {

Progress half_way() {
  Progress progress;
  progress.tick = 4500;
  progress.last_tick = 9000;
  progress.tick_s = 0.1;
  progress.ticks_per_s = 60.0;
  progress.standing = "created 40 intercepted 35 successful 1";
  return progress;
}

TEST(ProgressText, TellsHowFarHowFastAndHowWell) {
  EXPECT_EQ(progress_text(half_way()),
            "tick 4500/9000  ETA 1:15  60 ticks/s (6.0x)  created 40 intercepted 35 successful 1");
}

TEST(ProgressText, LeavesOutWhatIsNotKnownYet) { EXPECT_EQ(progress_text(Progress{}), "tick 0"); }

Tally tally_of(std::initializer_list<Happening> happenings) {
  Tally tally;
  for (const Happening& what : happenings) {
    tally.add({0, what});
  }
  return tally;
}

TEST(StandingText, OfAGuardCountsEnemies) {
  EXPECT_EQ(standing_text(tally_of({EnemyCreated{{1}, EnemyKind::Normal, {}}}), 6),
            "created 1 intercepted 0 successful 0");
}

TEST(StandingText, OfForagersCountsMinesAndAbleRobots) {
  const Tally tally =
      tally_of({ForageBegun{20}, MineStored{{1}, {4}, 19}, RobotDisabled{{2}, Mishap::Mud},
                RobotDisabled{{3}, Mishap::Enemy}, RobotRevived{{2}, {1}}});
  EXPECT_EQ(standing_text(tally, 6), "mines left 19/20  able 5/6");
}

TEST(StandingText, EndsWithWhatTheRobotsAreAtIfThatIsKnown) {
  const Tally tally = tally_of({ForageBegun{20}});
  EXPECT_EQ(standing_text(tally, 4, "3 Forager, 1 Soldier"),
            "mines left 20/20  able 4/4  (3 Forager, 1 Soldier)");
  EXPECT_EQ(standing_text(tally, 4, ""), "mines left 20/20  able 4/4");
}

TEST(DoingsText, CountsRobotsByRoleOrSituation) {
  Telemetry forager;
  forager.role = "Forager";
  forager.situation = "DetectEnemy";
  Telemetry guard;
  guard.situation = "AllClear";
  EXPECT_EQ(doings_text({{{1}, doing(forager)}, {{2}, doing(guard)}, {{3}, doing(forager)}}),
            "1 AllClear, 2 Forager");
  EXPECT_EQ(doings_text({{{1}, ""}}), "");
}

TEST(SecondsLeft, ShrinkAsTheSpeedGrows) {
  Progress faster = half_way();
  faster.ticks_per_s *= 3.0;

  EXPECT_EQ(seconds_left(half_way()), 75.0);
  EXPECT_EQ(seconds_left(faster), 25.0);
}

TEST(SecondsLeft, AreUnknownOfARunThatStands) {
  Progress standing = half_way();
  standing.ticks_per_s = 0.0;

  EXPECT_EQ(seconds_left(standing), std::nullopt);
}

TEST(ClockText, HasHoursOnlyWhenThereAreAny) {
  EXPECT_EQ(clock_text(0.0), "0:00");
  EXPECT_EQ(clock_text(7.2), "0:08");
  EXPECT_EQ(clock_text(750.0), "12:30");
  EXPECT_EQ(clock_text(11'100.0), "3:05:00");
}

}  // namespace
}  // namespace tacit
