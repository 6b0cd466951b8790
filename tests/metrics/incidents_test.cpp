#include "console/metrics/incidents.h"

#include <gtest/gtest.h>

namespace tacit {
namespace {

TEST(Collisions, AreCounted) {
  Collisions collisions;
  collisions.add({1, Collision{RobotId{1}, Obstruction::Wall, 2}});
  collisions.add({2, Collision{RobotId{2}, Obstruction::Robot, 1}});
  collisions.add({3, RobotLost{RobotId{1}}});

  EXPECT_EQ(collisions.count, 2);
}

TEST(Absences, AreCountedByKind) {
  Absences absences;
  absences.add({1, RobotLost{RobotId{1}}});
  absences.add({2, RobotLost{RobotId{2}}});
  absences.add({3, RobotBack{RobotId{1}}});
  absences.add({4, RobotLate{RobotId{1}}});
  absences.add({5, RobotLate{RobotId{1}}});
  absences.add({6, RobotLate{RobotId{1}}});

  EXPECT_EQ(absences.lost, 2);
  EXPECT_EQ(absences.back, 1);
  EXPECT_EQ(absences.late, 3);
}

TEST(Absences, ARunIsRepeatableUntilARobotIsLost) {
  Absences absences;
  absences.add({1, Collision{}});
  EXPECT_TRUE(absences.repeatable());

  absences.add({2, RobotLost{RobotId{1}}});
  EXPECT_FALSE(absences.repeatable());
}

TEST(Absences, ALateCommandMakesARunUnrepeatable) {
  Absences absences;
  absences.add({1, RobotLate{RobotId{1}}});

  EXPECT_FALSE(absences.repeatable());
}

TEST(Length, IsTheTickOfTheNewestEvent) {
  Length length;
  length.add({10, Collision{}});
  length.add({25, Checkpoint{}});

  EXPECT_EQ(length.ticks, 25);
  EXPECT_FALSE(length.complete);
}

TEST(Length, IsCompleteWithTheEndOfTheRun) {
  Length length;
  length.add({25, RunEnded{}});

  EXPECT_TRUE(length.complete);
}

}  // namespace
}  // namespace tacit
