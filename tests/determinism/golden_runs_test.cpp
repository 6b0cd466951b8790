// The same runs in every build: compiler settings, sanitizers and machines may differ, the event
// logs may not. The runs take every parameter from the defaults, learner, team and attack apart.

#include <gtest/gtest.h>

#include <array>
#include <cstdlib>
#include <fstream>
#include <map>
#include <string>
#include <vector>

#include "console/record/event_log.h"
#include "deploy/lockstep/setup.h"
#include "deploy/lockstep/team.h"

namespace tacit {
namespace {

// Long enough for the first enemies to come all the way.
constexpr Tick kGuardTicks = 1200;
constexpr Tick kForageTicks = 4000;
const std::string kFile = TACIT_SOURCE_DIR "/tests/determinism/golden.txt";

/// A run from its name and what it is made of.
struct GoldenRun {
  std::string name;
  Setup setup;
  std::uint64_t seed = 1;
  Tick last_tick = 0;
};

GoldenRun guard(const char* learner, std::int64_t strategy, std::int64_t robots,
                std::uint64_t seed) {
  GoldenRun run;
  run.name = std::string(learner) + " strategy " + std::to_string(strategy) + " robots " +
             std::to_string(robots) + " seed " + std::to_string(seed);
  run.setup.world.enemies.strategy = strategy;
  run.setup.world.robots.count = robots;
  run.setup.brain.learner = learner;
  run.seed = seed;
  run.last_tick = kGuardTicks;
  return run;
}

/// With many dangers and some obstacles, so that every rule has its turn.
GoldenRun forage(const char* learner, std::int64_t robots, std::uint64_t seed) {
  GoldenRun run{{}, setup_for(MissionKind::Forage)};
  run.name = std::string("forage ") + learner + " robots " + std::to_string(robots) + " seed " +
             std::to_string(seed);
  run.setup.world.robots.count = robots;
  run.setup.world.obstacles.coverage_percent = 2.0;
  run.setup.world.forage.mud.per_tick = 0.0005;
  run.setup.world.forage.hunters.count = 2;
  run.setup.world.forage.hunters.min_wait_ticks = 50;
  run.setup.world.forage.hunters.max_wait_ticks = 200;
  run.setup.brain.learner = learner;
  run.seed = seed;
  run.last_tick = kForageTicks;
  return run;
}

std::vector<GoldenRun> golden_runs() {
  return {guard("lm", 1, 6, 1),         guard("lm", 2, 3, 2),
          guard("lm", 3, 6, 3),         guard("lm", 4, 2, 4),
          guard("lm", 5, 1, 5),         guard("lm", 5, 25, 6),
          guard("lm", 0, 6, 7),         guard("static1", 1, 6, 8),
          guard("static1", 3, 3, 9),    guard("static2", 2, 6, 10),
          guard("static2", 4, 12, 11),  guard("crowd", 1, 12, 12),
          forage("q", 6, 13),           forage("q", 12, 14),
          forage("homogeneous", 3, 15), forage("heterogeneous", 8, 16)};
}

// SHA-256 of the event log.
std::string outcome(const GoldenRun& run) {
  Team team(run.setup.world, run.setup.brain, run.seed);
  EventHash hash;
  while (!team.done(run.last_tick)) {
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
  for (const GoldenRun& run : golden_runs()) {
    file << run.name << ": " << outcome(run) << '\n';
  }
  ASSERT_TRUE(file.flush()) << kFile << " cannot be written";
}

TEST(GoldenRuns, HaveTheSameEventLogInEveryBuild) {
  if (std::getenv("TACIT_REMAKE_GOLDEN") != nullptr) {
    remake();
    GTEST_SKIP() << kFile << " was made anew";
  }
  std::map<std::string, std::string> golden = golden_outcomes();
  const std::vector<GoldenRun> runs = golden_runs();
  EXPECT_EQ(golden.size(), runs.size()) << "in " << kFile;
  for (const GoldenRun& run : runs) {
    EXPECT_EQ(outcome(run), golden[run.name])
        << run.name << "; if the change is meant, set TACIT_REMAKE_GOLDEN=1 and run this again";
  }
}

}  // namespace
}  // namespace tacit
