#include "idl/bus/bell.h"

#include <gtest/gtest.h>

#include <thread>

namespace tacit {
namespace {

using namespace std::chrono_literals;
using Clock = Bell::Clock;

TEST(Bell, RemembersARingFromBeforeTheWait) {
  Bell bell;
  bell.ring();
  EXPECT_TRUE(bell.wait_until(Clock::now()));
}

TEST(Bell, CountsSeveralRingsAsOne) {
  Bell bell;
  bell.ring();
  bell.ring();
  EXPECT_TRUE(bell.wait_until(Clock::now()));
  EXPECT_FALSE(bell.wait_until(Clock::now()));
}

TEST(Bell, SleepsUntilTheGivenTimeWhenNobodyRings) {
  Bell bell;
  const Clock::time_point until = Clock::now() + 30ms;
  EXPECT_FALSE(bell.wait_until(until));
  EXPECT_GE(Clock::now(), until);
}

TEST(Bell, WakesASleeper) {
  Bell bell;
  std::thread ringer([&] {
    std::this_thread::sleep_for(20ms);
    bell.ring();
  });
  EXPECT_TRUE(bell.wait_until(Clock::now() + 20s));
  ringer.join();
}

TEST(Bell, LosesNoRingBetweenTwoThreadsThatTakeTurns) {
  Bell ping;
  Bell pong;
  constexpr int kTurns = 20000;
  std::thread partner([&] {
    for (int i = 0; i < kTurns; ++i) {
      ping.wait();
      pong.ring();
    }
  });
  for (int i = 0; i < kTurns; ++i) {
    ping.ring();
    ASSERT_TRUE(pong.wait_until(Clock::now() + 20s)) << i;
  }
  partner.join();
}

}  // namespace
}  // namespace tacit
