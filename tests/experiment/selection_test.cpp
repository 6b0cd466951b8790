#include "deploy/experiment/selection.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "deploy/experiment/held_out_table.h"
#include "deploy/experiment/summary.h"
#include "tests/experiment/small_battery.h"
#include "tests/process/programs.h"

namespace tacit {
namespace {

constexpr const char* kMetric = "created";

/// In training the faster enemy's cell is the better one, on held-out seeds the worse one.
std::vector<RecordedMetric> score(const Cell& cell, std::int64_t seed) {
  const bool faster = cell.level("enemies.speed_mps") == "2.0";
  const bool training = seed < 1000;
  const auto chance = static_cast<double>(seed % 8);
  if (cell.rival) {
    return {{kMetric, 50.0 + 2.0 * chance}};
  }
  return {{kMetric, (faster == training ? 20.0 : 40.0) + chance}};
}

class Selection : public testing::Test {
 protected:
  void train() { fill(store, battery, battery.runs(), score); }
  [[nodiscard]] Table tried() {
    train();
    fill(store, battery, held_out_runs(battery, store), score);
    return held_out_table(battery, store);
  }

  const Scratch folder;
  const Battery battery = small_battery(small_contest());
  RunStore store{folder / "runs.db"};
};

TEST_F(Selection, HoldsAContestForEveryScenarioAndTeamSize) {
  ExperimentConfig config = small_contest();
  config.scenarios = {"guard", "crowd"};
  config.teams = {{1, 2}, {2, 2}};
  const std::vector<Contest> all = contests(small_battery(config));
  ASSERT_EQ(all.size(), 4U);
  for (const Contest& contest : all) {
    EXPECT_EQ(contest.candidates.size(), 2U);
    EXPECT_EQ(contest.rivals.size(), 1U);
  }
}

TEST_F(Selection, IsNoneWithoutAMetric) { EXPECT_TRUE(contests(small_battery()).empty()); }

TEST_F(Selection, PicksTheSmallestMeanInTraining) {
  train();
  const std::size_t best = winner(battery, store, contests(battery).front()).value();
  EXPECT_EQ(battery.cells()[best].level("enemies.speed_mps"), "2.0");
}

TEST_F(Selection, WaitsForEveryRunOfTraining) {
  const auto& runs = battery.runs();
  fill(store, battery, std::span(runs).first(runs.size() - 2), score);
  EXPECT_FALSE(winner(battery, store, contests(battery).front()).has_value());
  EXPECT_TRUE(held_out_runs(battery, store).empty());
}

TEST_F(Selection, NeverPicksARival) {
  fill(store, battery, battery.runs(), [](const Cell& cell, std::int64_t /*seed*/) {
    return std::vector<RecordedMetric>{{kMetric, cell.rival ? 0.0 : 10.0}};
  });
  const std::size_t best = winner(battery, store, contests(battery).front()).value();
  EXPECT_FALSE(battery.cells()[best].rival);
}

TEST_F(Selection, RunsWinnersAndRivalsOnSeedsThatTrainingHasNotSeen) {
  train();
  std::set<std::int64_t> seeds;
  std::set<bool> rivals;
  for (const PlannedRun& run : held_out_runs(battery, store)) {
    seeds.insert(run.seed);
    rivals.insert(battery.cells()[run.cell].rival);
  }
  EXPECT_EQ(seeds, (std::set<std::int64_t>{1001, 1005}));
  EXPECT_EQ(rivals, (std::set<bool>{false, true}));
  EXPECT_EQ(held_out_runs(battery, store).size(), held_out_count(battery));
}

// Held out, the winner has 40 + 1 and 40 + 5, the rival 50 + 2 and 50 + 10; trained, it has
// 20 + 1, 20 + 5 and 20 + 1.
TEST_F(Selection, ComparesOnHeldOutSeedsOnly) {
  const Table table = tried();
  ASSERT_EQ(table.rows.size(), 1U);
  const auto& row = table.rows.front();
  EXPECT_EQ(std::get<std::string>(row[2]), "fixed");
  EXPECT_EQ(std::get<std::string>(row[3]), "speed_mps = 2.0");
  EXPECT_EQ(std::get<std::int64_t>(row[4]), 2);
  EXPECT_NEAR(std::get<double>(row[5]), 67.0 / 3.0, 1e-12);
  EXPECT_DOUBLE_EQ(std::get<Estimate>(row[6]).value, 43.0);
  EXPECT_DOUBLE_EQ(std::get<Estimate>(row[7]).value, 56.0);
  EXPECT_DOUBLE_EQ(std::get<Estimate>(row[8]).value, -13.0);
}

TEST_F(Selection, GivesEffectSizeAndBothTests) {
  const auto row = tried().rows.front();
  EXPECT_NEAR(std::get<double>(row[9]), -13.0 / std::sqrt(8.0), 1e-12);
  EXPECT_GT(std::get<double>(row[10]), 0.0);
  EXPECT_EQ(std::get<double>(row[11]), 0.5);
  EXPECT_EQ(row[10], row[12]);
}

TEST_F(Selection, LeavesTheTableOutWhileThereIsNoWinner) {
  for (const ReportTable& each : summarize(battery, store)) {
    EXPECT_NE(each.name, "held_out");
  }
}

}  // namespace
}  // namespace tacit
