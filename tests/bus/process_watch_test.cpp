#include "world_server/app/process_watch.h"

#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include "idl/bus/host_name.h"

namespace tacit {
namespace {

pid_t start_sleeper() {
  const pid_t child = fork();
  if (child == 0) {
    for (;;) pause();
  }
  return child;
}

/// Killed, and not yet waited for by its parent.
void end(pid_t child) {
  kill(child, SIGKILL);
  siginfo_t info{};
  waitid(P_PID, static_cast<id_t>(child), &info, WEXITED | WNOWAIT);
}

void bury(pid_t child) { waitpid(child, nullptr, 0); }

TEST(ProcessWatch, NoticesAKilledProcess) {
  const pid_t child = start_sleeper();
  ProcessWatch watch(2);
  watch.watch(1, child, host_name());
  watch.look();
  EXPECT_FALSE(watch.ended(1));
  end(child);
  watch.look();
  EXPECT_TRUE(watch.ended(1));
  EXPECT_FALSE(watch.ended(0));
  bury(child);
}

TEST(ProcessWatch, NoticesAProcessThatIsGoneAlready) {
  const pid_t child = start_sleeper();
  end(child);
  bury(child);
  ProcessWatch watch(1);
  watch.watch(0, child, host_name());
  EXPECT_TRUE(watch.ended(0));
}

TEST(ProcessWatch, SaysNothingOfAProcessOfAnotherHost) {
  const pid_t child = start_sleeper();
  end(child);
  bury(child);
  ProcessWatch watch(1);
  watch.watch(0, child, host_name() + "-not");
  watch.look();
  EXPECT_FALSE(watch.ended(0));
}

TEST(ProcessWatch, WatchesAnotherProcessInTheSameSlot) {
  const pid_t first = start_sleeper();
  const pid_t second = start_sleeper();
  ProcessWatch watch(1);
  watch.watch(0, first, host_name());
  end(first);
  watch.look();
  watch.watch(0, second, host_name());
  watch.look();
  EXPECT_FALSE(watch.ended(0));
  end(second);
  bury(first);
  bury(second);
}

}  // namespace
}  // namespace tacit
