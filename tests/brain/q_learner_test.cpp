#include "robot_agent/brain/learning/q_learner.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "idl/types/config_error.h"

namespace tacit {
namespace {

QLearner learner(QLearner::Shape shape, const QLearner::Config& config) {
  return {shape, config, {Stream(1, "initial q", 1), Stream(1, "role choice", 1)}};
}

QLearner::Config greedy_from_one() {
  QLearner::Config config;
  config.alpha = 0.5;
  config.epsilon = 0.0;
  config.initial_low = config.initial_high = 1.0;
  return config;
}

TEST(QLearner, BeginsWithValuesBetweenTheBounds) {
  const QTable table = learner({48, 3}, {}).table();
  ASSERT_EQ(table.q.size(), 144U);
  const auto [low, high] = std::minmax_element(table.q.begin(), table.q.end());
  EXPECT_GE(*low, 1.0);
  EXPECT_LT(*high, 2.0);
  EXPECT_GT(*high - *low, 0.9);
}

TEST(QLearner, FollowsATraceWorkedOutByHand) {
  QLearner subject = learner({2, 2}, greedy_from_one());

  EXPECT_EQ(subject.query(0, 7.0), 0U);  // The first query learns nothing.
  EXPECT_EQ(subject.table().q, (std::vector<double>{1, 1, 1, 1}));

  EXPECT_EQ(subject.query(1, 10.0), 0U);  // 1 + 0.5 (10 + 0.8 * 1 - 1) = 5.9
  EXPECT_DOUBLE_EQ(subject.table().q[0], 5.9);

  EXPECT_EQ(subject.query(0, 0.0), 0U);  // 1 + 0.5 (0 + 0.8 * 5.9 - 1) = 2.86
  EXPECT_DOUBLE_EQ(subject.table().q[2], 2.86);

  // 5.9 + 0.5 (-20 + 0.8 * 5.9 - 5.9) = -4.69; the best was looked up before.
  EXPECT_EQ(subject.query(0, -20.0), 0U);
  EXPECT_DOUBLE_EQ(subject.table().q[0], -4.69);

  EXPECT_EQ(subject.query(0, 0.0), 1U);  // -4.69 + 0.5 (0 + 0.8 * 1 + 4.69) = -1.945
  EXPECT_DOUBLE_EQ(subject.table().q[0], -1.945);

  EXPECT_EQ(subject.table().visits, (std::vector<std::uint64_t>{3, 1, 1, 0}));
  EXPECT_EQ(subject.table().updates, 4U);
  EXPECT_EQ(subject.table().policy_changes, 1U);
  EXPECT_EQ(subject.last(), (QLearner::Choice{0, 1}));
}

TEST(QLearner, TakesTheFirstOfEquallyGoodActions) {
  QLearner subject = learner({1, 3}, greedy_from_one());
  EXPECT_EQ(subject.query(0, 0.0), 0U);
}

TEST(QLearner, ExploresAllActionsAlikeWithTheChanceEpsilon) {
  QLearner::Config config = greedy_from_one();
  config.epsilon = 0.6;
  config.alpha = 0.0;
  QLearner subject = learner({1, 3}, config);
  for (int i = 0; i < 30000; ++i) static_cast<void>(subject.query(0, 0.0));
  const QTable& table = subject.table();
  EXPECT_NEAR(static_cast<double>(table.visits[0]), 18000.0, 400.0);
  EXPECT_NEAR(static_cast<double>(table.visits[1]), 6000.0, 300.0);
  EXPECT_NEAR(static_cast<double>(table.visits[2]), 6000.0, 300.0);
}

TEST(QLearner, ThatDoesNotLearnIsGreedyAndKeepsItsTable) {
  QLearner::Config config;
  config.epsilon = 1.0;
  config.learning = false;
  QLearner subject = learner({4, 3}, config);
  const QTable before = subject.table();
  for (std::size_t i = 0; i < 100; ++i) {
    EXPECT_EQ(subject.query(i % 4, 5.0), before.greedy(i % 4));
  }
  EXPECT_EQ(subject.table(), before);
  subject.inherit(before);
  EXPECT_EQ(subject.table(), before);
}

TEST(QLearner, DecaysItsRatesOncePerRunInherited) {
  QLearner::Config config;
  config.epsilon_decay = 0.5;
  QLearner second = learner({4, 3}, config);
  second.inherit(learner({4, 3}, config).table());
  EXPECT_DOUBLE_EQ(second.table().alpha, 0.09);
  EXPECT_DOUBLE_EQ(second.table().epsilon, 0.05);
  EXPECT_EQ(second.table().runs, 2U);
  for (int i = 0; i < 50; ++i) static_cast<void>(second.query(0, 1.0));
  EXPECT_DOUBLE_EQ(second.table().alpha, 0.09);
  EXPECT_DOUBLE_EQ(second.table().epsilon, 0.05);
  QLearner third = learner({4, 3}, config);
  third.inherit(second.table());
  EXPECT_DOUBLE_EQ(third.table().alpha, 0.081);
  EXPECT_EQ(third.table().runs, 3U);
}

TEST(QLearner, ResumesWithoutDecay) {
  QLearner first = learner({4, 3}, {});
  static_cast<void>(first.query(0, 0.0));
  QLearner second = learner({4, 3}, {});
  second.resume(first.table(), first.last(), first.exploration_position());
  EXPECT_EQ(second.table(), first.table());
  EXPECT_EQ(second.query(1, 3.0), first.query(1, 3.0));
  EXPECT_EQ(second.table(), first.table());
}

TEST(QLearner, IsRefusedWithBoundsTheWrongWayRound) {
  QLearner::Config config;
  config.initial_low = 3.0;
  EXPECT_THROW(check(config), ConfigError);
}

/// A small decision problem whose solution is known by value iteration.
struct Outcome {
  std::size_t state;
  double reward;
};
constexpr std::size_t kStates = 4;
constexpr std::size_t kActions = 3;
using Problem = std::array<std::array<Outcome, kActions>, kStates>;
constexpr Problem kProblem{{
    {{{0, 1.0}, {1, 0.0}, {2, -1.0}}},
    {{{0, 0.0}, {1, 2.0}, {3, 0.0}}},
    {{{3, 4.0}, {0, 0.0}, {2, 0.0}}},
    {{{0, 9.0}, {3, 1.0}, {1, 0.5}}},
}};

std::vector<double> solution(double gamma) {
  std::vector<double> q(kStates * kActions, 0.0);
  for (int sweep = 0; sweep < 500; ++sweep) {
    for (std::size_t cell = 0; cell < q.size(); ++cell) {
      const Outcome& outcome = kProblem[cell / kActions][cell % kActions];
      const auto row = q.begin() + static_cast<std::ptrdiff_t>(outcome.state * kActions);
      q[cell] = outcome.reward + gamma * *std::max_element(row, row + kActions);
    }
  }
  return q;
}

TEST(QLearner, ConvergesToWhatValueIterationFinds) {
  QLearner::Config config;
  config.alpha = 0.2;
  config.epsilon = 0.5;
  QLearner subject = learner({kStates, kActions}, config);
  Outcome now{0, 0.0};
  for (int step = 0; step < 20000; ++step) {
    now = kProblem[now.state][subject.query(now.state, now.reward)];
  }
  QTable wanted = subject.table();
  wanted.q = solution(config.gamma);
  for (std::size_t cell = 0; cell < wanted.q.size(); ++cell) {
    EXPECT_NEAR(subject.table().q[cell], wanted.q[cell], 1e-6) << cell;
  }
  for (std::size_t state = 0; state < kStates; ++state) {
    EXPECT_EQ(subject.table().greedy(state), wanted.greedy(state)) << state;
  }
}

}  // namespace
}  // namespace tacit
