#include "deploy/experiment/chain.h"

#include <gtest/gtest.h>

#include "console/record/event_log.h"
#include "deploy/lockstep/team.h"

namespace tacit {
namespace {

/// Three learning soldiers for 30 simulated seconds.
Setup soldiers() {
  Setup setup;
  setup.run.seed = 7;
  setup.run.duration_s = 30.0;
  setup.world.robots.count = 3;
  setup.world.obstacles.coverage_percent = 0.0;
  return setup;
}

/// Two foragers that run out of time soon.
Setup foragers() {
  Setup setup = setup_for(MissionKind::Forage);
  setup.run.duration_s = 600.0;
  setup.world.robots.count = 2;
  setup.world.forage.cap_ticks = 200;
  return setup;
}

bool never() { return false; }

Chain finished(const Setup& setup, ChainLength length) {
  Chain chain(setup, length);
  while (!chain.done()) {
    EXPECT_TRUE(chain.next(never).has_value());
  }
  return chain;
}

void run(Team& team, const Setup& setup, EventHash& log) {
  while (!team.done(last_tick(setup))) {
    log.add(team.step());
  }
  const Event ending = team.ending();
  log.add({&ending, 1});
}

/// The hash of two runs one after the other, the second with what the first taught, or without.
std::string hash_of_two(const Setup& first, bool inherits) {
  EventHash log;
  Team team(first.world, first.brain, seed(first));
  run(team, first, log);
  Team next(first.world, first.brain, seed(first) + 1);
  if (inherits) {
    std::vector<PolicyText> policies;
    for (const std::string& text : team.policies()) {
      policies.push_back({text, "test"});
    }
    next.inherit(policies);
  }
  run(next, first, log);
  return log.hex();
}

TEST(Chain, GivesEveryRunTheNextSeed) {
  const Chain chain = finished(soldiers(), {3, 1});
  ASSERT_EQ(chain.episodes().size(), 3U);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(chain.episodes()[i].seed, 7 + static_cast<std::int64_t>(i));
    EXPECT_EQ(chain.episodes()[i].number, 1 + static_cast<std::int64_t>(i));
  }
}

TEST(Chain, BeginsEveryRunWithWhatTheOneBeforeTaught) {
  const std::string hash = finished(soldiers(), {2, 1}).outcome(1.0).event_log_sha256;
  EXPECT_EQ(hash, hash_of_two(soldiers(), true));
  EXPECT_NE(hash, hash_of_two(soldiers(), false));
}

TEST(Chain, BeginsTheFirstRunWithThePoliciesGiven) {
  const Chain first = finished(soldiers(), {1, 1});
  tacit::Setup next = soldiers();
  ++next.run.seed;
  Chain second(next, {1, 1}, first.policies());
  (void)second.next(never);
  const Chain both = finished(soldiers(), {2, 1});
  EXPECT_EQ(second.policies().front().text, both.policies().front().text);
}

TEST(Chain, BeginsEveryRunAnewWhenTheTeamDoesNotLearn) {
  tacit::Setup setup = soldiers();
  setup.brain.learner = "static1";
  const Chain chain = finished(setup, {2, 1});
  EXPECT_TRUE(chain.policies().empty());
  EXPECT_EQ(chain.outcome(1.0).event_log_sha256, hash_of_two(setup, false));
}

TEST(Chain, OfOneRunHasItsMetrics) {
  const Chain chain = finished(soldiers(), {1, 1});
  EXPECT_EQ(chain.outcome(1.0).metrics, recorded(chain.episodes().front().tally));
}

TEST(Chain, AveragesTheRunsThatCount) {
  const Chain chain = finished(soldiers(), {3, 2});
  const auto created = [&](std::size_t i) {
    return chain.episodes()[i].tally.value("created").value();
  };
  EXPECT_EQ(chain.outcome(1.0).metric("created"), (created(1) + created(2)) / 2.0);
}

TEST(Chain, CountsTheTicksOfAllRuns) {
  const RunOutcome outcome = finished(soldiers(), {3, 1}).outcome(1.0);
  EXPECT_EQ(outcome.ticks, 900U);
  EXPECT_TRUE(outcome.complete);
  EXPECT_TRUE(outcome.repeatable);
}

TEST(Chain, KeepsTheScoreOfEveryRun) {
  const RunOutcome outcome = finished(foragers(), {3, 2}).outcome(1.0);
  for (const char* key : {"score_ticks_1", "score_ticks_2", "score_ticks_3", "score_ticks"}) {
    EXPECT_EQ(outcome.metric(key), 200.0) << key;
  }
  EXPECT_EQ(outcome.metric("failed"), 1.0);
}

TEST(Chain, EndsARunWhenItsMissionIsOver) {
  EXPECT_EQ(finished(foragers(), {1, 1}).episodes().front().ticks, 200U);
}

TEST(Chain, EndsEarlyWhenTold) {
  Chain chain(soldiers(), {2, 1});
  EXPECT_TRUE(chain.next(never).has_value());
  const std::string learned = chain.policies().front().text;
  EXPECT_FALSE(chain.next([] { return true; }).has_value());
  EXPECT_EQ(chain.episodes().size(), 1U);
  EXPECT_EQ(chain.policies().front().text, learned);
}

}  // namespace
}  // namespace tacit
