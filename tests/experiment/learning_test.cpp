#include <gtest/gtest.h>

#include "console/report/estimate.h"
#include "deploy/experiment/chain.h"

namespace tacit {
namespace {

constexpr std::int64_t kLessons = 30;
constexpr std::int64_t kTrials = 20;

/// Six foragers in the field of twenty mines.
Setup foragers(std::int64_t first_seed) {
  Setup setup = setup_for(MissionKind::Forage);
  setup.run.seed = first_seed;
  setup.run.duration_s = 1e6;
  setup.world.forage.mines.seed = 102;
  setup.world.forage.cap_ticks = 50'000;
  return setup;
}

std::vector<double> scores(Chain& chain) {
  std::vector<double> all;
  while (!chain.done()) {
    const auto episode = chain.next([] { return false; });
    all.push_back(episode->tally.value("score_ticks").value());
  }
  return all;
}

std::vector<PolicyText> learned(std::int64_t first_seed) {
  Chain chain(foragers(first_seed), {kLessons, 1});
  static_cast<void>(scores(chain));
  return chain.policies();
}

/// Each on the same seeds: a team that takes the best role it knows and learns no more.
std::vector<double> greedy_scores(const std::vector<PolicyText>& policies) {
  std::vector<double> all;
  for (std::int64_t seed = 5001; seed < 5001 + kTrials; ++seed) {
    Setup setup = foragers(seed);
    setup.brain.q.learner.learning = false;
    Chain run(setup, {1, 1}, policies);
    all.push_back(scores(run).front());
  }
  return all;
}

std::vector<double> fresh_scores() {
  std::vector<double> all;
  for (std::int64_t seed = 5001; seed < 5001 + kTrials; ++seed) {
    Chain run(foragers(seed), {1, 1});
    all.push_back(scores(run).front());
  }
  return all;
}

TEST(Learning, OfAPolicyTakenGreedilyBeatsAFreshTableOnOtherSeeds) {
  const auto difference = paired_difference(greedy_scores(learned(1)), fresh_scores());
  ASSERT_TRUE(difference);
  EXPECT_LT(difference->estimate.high, 0.0) << difference->estimate.value;
}

TEST(Learning, LowersTheScoreFromTheFirstRunsToTheLast) {
  std::vector<double> first;
  std::vector<double> last;
  for (std::int64_t chain = 0; chain < 6; ++chain) {
    Chain runs(foragers(1 + chain * kLessons), {kLessons, 1});
    const std::vector<double> all = scores(runs);
    for (std::size_t i = 0; i < 3; ++i) {
      first.push_back(all[i]);
      last.push_back(all[all.size() - 3 + i]);
    }
  }
  const auto difference = paired_difference(last, first);
  ASSERT_TRUE(difference);
  EXPECT_LT(difference->estimate.high, 0.0) << difference->estimate.value;
}

}  // namespace
}  // namespace tacit
