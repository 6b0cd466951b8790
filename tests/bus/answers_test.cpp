#include "robot_agent/app/answers.h"

#include <gtest/gtest.h>

namespace tacit {
namespace {

Percept percept(Tick tick) {
  Percept p;
  p.robot = {1};
  p.tick = tick;
  return p;
}

/// Decides differently every time it is asked.
Answers counting_answers() {
  return Answers([n = 0](const Percept& p) mutable {
    Command command;
    command.robot = p.robot;
    command.tick = p.tick;
    command.turn_radps = ++n;
    return command;
  });
}

TEST(Answers, DecideOnceForEachNewTick) {
  Answers answers = counting_answers();
  EXPECT_EQ(answers.to(percept(0))->turn_radps, 1.0);
  EXPECT_EQ(answers.to(percept(1))->turn_radps, 2.0);
  EXPECT_EQ(answers.decisions(), 2U);
}

TEST(Answers, RepeatTheCommandOfTheLastTick) {
  Answers answers = counting_answers();
  (void)answers.to(percept(7));
  const Command* again = answers.to(percept(7));
  ASSERT_NE(again, nullptr);
  EXPECT_EQ(again->turn_radps, 1.0);
  EXPECT_EQ(answers.decisions(), 1U);
  EXPECT_EQ(answers.duplicates(), 1U);
}

TEST(Answers, AreNotGivenToAnOldTick) {
  Answers answers = counting_answers();
  (void)answers.to(percept(7));
  EXPECT_EQ(answers.to(percept(6)), nullptr);
  EXPECT_EQ(answers.decisions(), 1U);
}

TEST(Answers, BeginAtAnyTick) {
  Answers answers = counting_answers();
  ASSERT_NE(answers.to(percept(500)), nullptr);
}

}  // namespace
}  // namespace tacit
