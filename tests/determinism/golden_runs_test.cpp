// The same runs in every build: compiler settings, sanitizers and machines may differ, the event
// logs may not. The runs take every parameter from the defaults, learner, team and attack apart.

#include <gtest/gtest.h>

#include <array>
#include <cstdlib>
#include <fstream>
#include <map>
#include <string>

#include "console/record/event_log.h"
#include "deploy/lockstep/team.h"

namespace tacit {
namespace {

// Long enough for the first enemies to come all the way.
constexpr Tick kTicks = 1200;
const std::string kFile = TACIT_SOURCE_DIR "/tests/determinism/golden.txt";

struct GoldenRun {
  const char* learner;
  std::int64_t strategy;
  std::int64_t robots;
  std::uint64_t seed;
};

constexpr std::array<GoldenRun, 12> kRuns{{
    {"lm", 1, 6, 1},
    {"lm", 2, 3, 2},
    {"lm", 3, 6, 3},
    {"lm", 4, 2, 4},
    {"lm", 5, 1, 5},
    {"lm", 5, 25, 6},
    {"lm", 0, 6, 7},
    {"static1", 1, 6, 8},
    {"static1", 3, 3, 9},
    {"static2", 2, 6, 10},
    {"static2", 4, 12, 11},
    {"crowd", 1, 12, 12},
}};

std::string name(const GoldenRun& run) {
  return std::string(run.learner) + " strategy " + std::to_string(run.strategy) + " robots " +
         std::to_string(run.robots) + " seed " + std::to_string(run.seed);
}

// SHA-256 of the event log.
std::string outcome(const GoldenRun& run) {
  WorldConfig world;
  world.enemies.strategy = run.strategy;
  world.robots.count = run.robots;
  BrainConfig brain;
  brain.learner = run.learner;
  Team team(world, brain, run.seed);
  EventHash hash;
  while (team.tick() < kTicks) {
    hash.add(team.step());
  }
  const std::array<Event, 1> ending{team.ending()};
  hash.add(ending);
  return hash.hex();
}

// Lines "name: hash".
std::map<std::string, std::string> golden_outcomes() {
  std::map<std::string, std::string> outcomes;
  std::ifstream file(kFile);
  for (std::string line; std::getline(file, line);) {
    const std::size_t colon = line.find(": ");
    if (colon != std::string::npos) {
      outcomes[line.substr(0, colon)] = line.substr(colon + 2);
    }
  }
  return outcomes;
}

void remake() {
  std::ofstream file(kFile);
  for (const GoldenRun& run : kRuns) {
    file << name(run) << ": " << outcome(run) << '\n';
  }
  ASSERT_TRUE(file.flush()) << kFile << " cannot be written";
}

TEST(GoldenRuns, HaveTheSameEventLogInEveryBuild) {
  if (std::getenv("TACIT_REMAKE_GOLDEN") != nullptr) {
    remake();
    GTEST_SKIP() << kFile << " was made anew";
  }
  std::map<std::string, std::string> golden = golden_outcomes();
  EXPECT_EQ(golden.size(), kRuns.size()) << "in " << kFile;
  for (const GoldenRun& run : kRuns) {
    EXPECT_EQ(outcome(run), golden[name(run)])
        << name(run) << "; if the change is meant, set TACIT_REMAKE_GOLDEN=1 and run this again";
  }
}

}  // namespace
}  // namespace tacit
