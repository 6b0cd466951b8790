#include "world_server/app/barrier.h"

#include <gtest/gtest.h>

#include <atomic>
#include <thread>

#include "idl/bus/bell.h"

namespace tacit {
namespace {

using Clock = Bell::Clock;

Command command(std::uint16_t robot, Tick tick, double turn = 0.0) {
  Command c;
  c.robot = {robot};
  c.tick = tick;
  c.turn_radps = turn;
  return c;
}

class Barriers : public testing::Test {
 protected:
  bool rung() { return bell_.wait_until(Clock::now()); }

  Bell bell_;
  Barrier barrier_{3, [this] { bell_.ring(); }};
};

TEST_F(Barriers, AreCompleteWhenEveryAwaitedRobotHasAnswered) {
  barrier_.open(5, {true, false, true});
  EXPECT_EQ(barrier_.put(command(3, 5)), Arrival::Awaited);
  EXPECT_FALSE(barrier_.complete());
  EXPECT_EQ(barrier_.put(command(1, 5)), Arrival::Awaited);
  EXPECT_TRUE(barrier_.complete());
}

TEST_F(Barriers, CallOnceAndForTheLastCommandAlone) {
  barrier_.open(5, {true, true, true});
  barrier_.put(command(1, 5));
  barrier_.put(command(2, 5));
  EXPECT_FALSE(rung());
  barrier_.put(command(3, 5));
  EXPECT_TRUE(rung());
  barrier_.put(command(3, 5));
  EXPECT_FALSE(rung());
}

TEST_F(Barriers, GiveCommandsInOrderOfId) {
  barrier_.open(0, {true, true, true});
  barrier_.put(command(3, 0));
  barrier_.put(command(1, 0));
  barrier_.put(command(2, 0));
  const auto commands = barrier_.close();
  ASSERT_EQ(commands.size(), 3U);
  for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(commands[i].robot.value, i + 1);
}

TEST_F(Barriers, KeepTheFirstCommandOfARobot) {
  barrier_.open(0, {true, true, true});
  barrier_.put(command(2, 0, 0.25));
  EXPECT_EQ(barrier_.put(command(2, 0, 0.75)), Arrival::Known);
  EXPECT_EQ(barrier_.close().front().turn_radps, 0.25);
}

TEST_F(Barriers, IgnoreCommandsOfOtherTicks) {
  barrier_.open(5, {true, true, true});
  EXPECT_EQ(barrier_.put(command(1, 4)), Arrival::OffTick);
  EXPECT_EQ(barrier_.put(command(1, 6)), Arrival::OffTick);
  EXPECT_TRUE(barrier_.close().empty());
}

TEST_F(Barriers, IgnoreRobotsThatAreNotAwaited) {
  barrier_.open(5, {true, false, true});
  EXPECT_EQ(barrier_.put(command(2, 5)), Arrival::OffTick);
  EXPECT_TRUE(barrier_.close().empty());
}

TEST_F(Barriers, TellStrangers) {
  barrier_.open(5, {true, true, true});
  EXPECT_EQ(barrier_.put(command(4, 5)), Arrival::Stranger);
  EXPECT_EQ(barrier_.put(command(0, 5)), Arrival::Stranger);
}

TEST_F(Barriers, DoNotWaitForTheExcused) {
  barrier_.open(5, {true, true, false});
  barrier_.put(command(1, 5));
  barrier_.excuse({2});
  EXPECT_TRUE(barrier_.complete());
  EXPECT_EQ(barrier_.close().size(), 1U);
}

TEST_F(Barriers, DropTheCommandOfAnExcusedRobot) {
  barrier_.open(5, {true, true, false});
  barrier_.put(command(1, 5));
  barrier_.excuse({1});
  EXPECT_FALSE(barrier_.complete());
  EXPECT_TRUE(barrier_.close().empty());
}

TEST_F(Barriers, NameWhoIsMissing) {
  barrier_.open(5, {true, true, false});
  barrier_.put(command(1, 5));
  EXPECT_EQ(barrier_.missing(), std::vector<RobotId>{{2}});
}

TEST_F(Barriers, TakeNoCommandOnceClosed) {
  barrier_.open(5, {true, true, true});
  (void)barrier_.close();
  EXPECT_EQ(barrier_.put(command(1, 5)), Arrival::OffTick);
}

TEST_F(Barriers, WakeTheirThreadForCommandsFromManyThreads) {
  constexpr Tick kTicks = 2000;
  std::vector<std::thread> agents;
  std::atomic<Tick> open_tick{0};
  barrier_.open(0, {true, true, true});
  for (std::uint16_t robot = 1; robot <= 3; ++robot) {
    agents.emplace_back([&, robot] {
      for (Tick tick = 0; tick < kTicks; ++tick) {
        while (open_tick.load() < tick) std::this_thread::yield();
        barrier_.put(command(robot, tick));
      }
    });
  }
  for (Tick tick = 0; tick < kTicks; ++tick) {
    while (!barrier_.complete()) {
      ASSERT_TRUE(bell_.wait_until(Clock::now() + std::chrono::seconds(20))) << tick;
    }
    ASSERT_EQ(barrier_.close().size(), 3U);
    barrier_.open(tick + 1, {true, true, true});
    open_tick = tick + 1;
  }
  for (std::thread& agent : agents) agent.join();
}

}  // namespace
}  // namespace tacit
