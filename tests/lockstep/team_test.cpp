#include "deploy/lockstep/team.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <thread>
#include <utility>
#include <vector>

#include "idl/types/config_error.h"
#include "tests/lockstep/sample_teams.h"

namespace tacit {
namespace {

constexpr Tick kTicks = 800;

History played(const char* learner, std::uint64_t seed, Tick ticks = kTicks) {
  Team team(busy_world(), brain_with(learner), seed);
  History history;
  play(team, ticks, history);
  return history;
}

TEST(Team, ReplaysItselfBitForBitWithEveryLearner) {
  for (const char* learner : {"static1", "static2", "lm", "crowd"}) {
    const History first = played(learner, 7);
    EXPECT_GT(first.events.size(), 20u);
    EXPECT_EQ(first, played(learner, 7)) << learner;
  }
}

TEST(Team, HasAnotherHistoryWithAnotherSeed) {
  EXPECT_NE(played("lm", 7).digest, played("lm", 8).digest);
}

TEST(Team, HasAnotherHistoryWithAnotherLearner) {
  EXPECT_NE(played("static1", 7).digest, played("static2", 7).digest);
}

TEST(Team, HasTheSameHistoryInAThreadBesideAnother) {
  const History alone_first = played("lm", 7);
  const History alone_second = played("static1", 8);
  History first;
  History second;
  std::thread one([&first] { first = played("lm", 7); });
  std::thread other([&second] { second = played("static1", 8); });
  one.join();
  other.join();
  EXPECT_EQ(first, alone_first);
  EXPECT_EQ(second, alone_second);
}

TEST(Team, HasTheSameHistoryStepByStepBesideAnother) {
  const History alone = played("lm", 7);
  Team team(busy_world(), brain_with("lm"), 7);
  Team other(busy_world(), brain_with("lm"), 8);
  History history;
  for (Tick i = 0; i < kTicks; ++i) {
    other.step();
    play(team, 1, history);
  }
  EXPECT_EQ(history, alone);
}

TEST(Team, HasTheSameHistoryWhenMovedHalfway) {
  Team first(busy_world(), brain_with("lm"), 7);
  History history;
  play(first, kTicks / 2, history);
  Team second = std::move(first);
  play(second, kTicks / 2, history);
  EXPECT_EQ(history, played("lm", 7));
}

TEST(Team, StartsASecondRunLikeTheFirst) {
  const History before = played("lm", 7, 300);
  static_cast<void>(played("lm", 9, 300));
  EXPECT_EQ(played("lm", 7, 300), before);
}

// What processes do: each brain decides by itself, in whatever order the percepts arrive.
TEST(Team, IsItsBrainsAndItsWorldWhateverTheOrderOfDecisions) {
  World world(busy_world(), 7);
  std::vector<Brain> brains;
  for (const Percept& percept : world.percepts()) {
    brains.emplace_back(brain_with("lm"), percept.robot, 7);
  }
  History history;
  for (Tick i = 0; i < kTicks; ++i) {
    std::vector<Command> commands;
    for (std::size_t k = brains.size(); k-- > 0;) {
      commands.push_back(brains[k].decide(world.percepts()[k]));
    }
    const auto events = world.step(commands);
    history.events.insert(history.events.end(), events.begin(), events.end());
  }
  history.digest = world.digest();
  EXPECT_EQ(history, played("lm", 7));
}

TEST(Team, EndsWithItsTickAndDigest) {
  Team team(busy_world(), brain_with("lm"), 7);
  for (int i = 0; i < 50; ++i) {
    team.step();
  }
  EXPECT_EQ(team.ending(), (Event{50, RunEnded{team.world().digest()}}));
}

TEST(Team, HasABrainForEveryRobot) {
  const Team team(busy_world(5), brain_with("lm"), 7);
  EXPECT_EQ(team.brains().size(), 5u);
}

TEST(Team, RefusesAWorldThatCannotBe) {
  WorldConfig config = busy_world();
  config.target.x_m = -1.0;
  EXPECT_THROW(Team(config, brain_with("lm"), 7), ConfigError);
}

TEST(Team, RefusesALearnerThatDoesNotExist) {
  EXPECT_THROW(Team(busy_world(), brain_with("genius"), 7), ConfigError);
}

}  // namespace
}  // namespace tacit
