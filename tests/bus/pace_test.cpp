#include "world_server/app/pace.h"

#include <gtest/gtest.h>

namespace tacit {
namespace {

using std::chrono::milliseconds;

const Pace::Time kStart = Pace::Time() + std::chrono::hours(1);

Control control(ControlKind kind, std::uint32_t ticks = 1, double speed = 0.0) {
  return {kind, ticks, speed};
}

TEST(Pace, NeverWaitsAtFullSpeed) {
  Pace pace(0.0, 0.1);
  pace.began(kStart);
  EXPECT_EQ(pace.next_tick_at(kStart), kStart);
}

TEST(Pace, KeepsThePeriodOfItsSpeed) {
  Pace pace(2.0, 0.1);
  EXPECT_EQ(pace.next_tick_at(kStart), kStart);
  pace.began(kStart);
  EXPECT_EQ(pace.next_tick_at(kStart), kStart + milliseconds(50));
}

TEST(Pace, IsLeftAsItIsByAnOperatorsWords) {
  Pace pace(2.0, 0.1);
  pace.began(kStart);
  for (const ControlKind kind :
       {ControlKind::Steer, ControlKind::LetGo, ControlKind::Proceed, ControlKind::SkipGoal}) {
    pace.hear(control(kind));
  }
  EXPECT_FALSE(pace.paused() || pace.stopped());
  EXPECT_EQ(pace.next_tick_at(kStart), kStart + milliseconds(50));
}

TEST(Pace, MakesUpForALittleLateness) {
  Pace pace(1.0, 0.1);
  pace.began(kStart);
  pace.began(kStart + milliseconds(130));
  EXPECT_EQ(pace.next_tick_at(kStart), kStart + milliseconds(200));
}

TEST(Pace, DoesNotHurryAfterALongHalt) {
  Pace pace(1.0, 0.1);
  pace.began(kStart);
  const Pace::Time late = kStart + std::chrono::seconds(10);
  pace.began(late);
  EXPECT_EQ(pace.next_tick_at(late), late);
  pace.began(late);
  pace.began(late);
  EXPECT_GE(pace.next_tick_at(late), late + milliseconds(100));
}

TEST(Pace, WaitsForeverWhilePaused) {
  Pace pace(0.0, 0.1);
  pace.hear(control(ControlKind::Pause));
  EXPECT_TRUE(pace.paused());
  EXPECT_EQ(pace.next_tick_at(kStart), std::nullopt);
}

TEST(Pace, MakesAsManyStepsAsAskedForWhilePaused) {
  Pace pace(1.0, 0.1);
  pace.hear(control(ControlKind::Pause));
  pace.hear(control(ControlKind::Step, 2));
  for (int i = 0; i < 2; ++i) {
    ASSERT_EQ(pace.next_tick_at(kStart), kStart) << i;
    pace.began(kStart);
  }
  EXPECT_EQ(pace.next_tick_at(kStart), std::nullopt);
}

TEST(Pace, IgnoresAStepWhileItRuns) {
  Pace pace(0.0, 0.1);
  pace.hear(control(ControlKind::Step, 5));
  pace.hear(control(ControlKind::Pause));
  EXPECT_EQ(pace.next_tick_at(kStart), std::nullopt);
}

TEST(Pace, GoesOnAtOnceAfterAPause) {
  Pace pace(1.0, 0.1);
  pace.began(kStart);
  pace.hear(control(ControlKind::Pause));
  pace.hear(control(ControlKind::Resume));
  EXPECT_EQ(pace.next_tick_at(kStart), kStart);
}

TEST(Pace, TakesAnotherSpeed) {
  Pace pace(0.0, 0.1);
  pace.hear(control(ControlKind::Speed, 1, 10.0));
  pace.began(kStart);
  EXPECT_EQ(pace.next_tick_at(kStart), kStart + milliseconds(10));
}

TEST(Pace, RemembersThatItWasStopped) {
  Pace pace(0.0, 0.1);
  pace.hear(control(ControlKind::Stop));
  EXPECT_TRUE(pace.stopped());
}

}  // namespace
}  // namespace tacit
