#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>

#include "tests/lockstep/sample_teams.h"

namespace tacit {
namespace {

// A sanitizer keeps freed memory and shadows of it, which is not the team's.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool kSanitized = true;
#else
constexpr bool kSanitized = false;
#endif

std::size_t resident_bytes() {
  std::ifstream statm("/proc/self/statm");
  std::size_t total = 0;
  std::size_t resident = 0;
  statm >> total >> resident;
  return resident * static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
}

void run_to(Team& team, Tick tick) {
  while (team.tick() < tick) {
    team.step();
  }
}

TEST(Team, NeedsNoMoreMemoryAfterTwoHundredThousandTicks) {
  if (kSanitized) {
    GTEST_SKIP() << "a sanitizer's own memory grows";
  }
  WorldConfig world = busy_world(2);
  world.enemies.strategy = 5;
  Team team(world, brain_with("lm"), 7);
  run_to(team, 20000);
  const std::size_t early = resident_bytes();
  run_to(team, 200000);
  EXPECT_LT(resident_bytes(), early + 512 * 1024);
}

}  // namespace
}  // namespace tacit
