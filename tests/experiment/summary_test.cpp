#include "deploy/experiment/summary.h"

#include <gtest/gtest.h>

#include "tests/experiment/small_battery.h"
#include "tests/process/programs.h"

namespace tacit {
namespace {

/// A store filled by hand, so that every figure of the summary can be worked out on paper.
class Summary : public testing::Test {
 protected:
  const Scratch folder;
  Summary() {
    fill(store, battery, battery.runs(), [](const Cell& cell, std::int64_t seed) {
      const double learner = cell.levels[0].value == "lm" ? 3.0 : 0.0;
      // Of no effect on a mean over two seeds, and other for one learner than for the other.
      const double chance = (seed % 2 == 0 ? 0.5 : -0.5) * (learner > 0 ? 0.9 : 1.0);
      return std::vector<RecordedMetric>{
          {"mean_death_distance_m", 30.0 * static_cast<double>(cell.robots) + learner + chance},
          {"intercept_percent", 100.0}};
    });
  }

  const Battery battery = small_battery();
  RunStore store{folder / "runs.db"};
};

TEST_F(Summary, AveragesEachCell) {
  const Table cells = summarize(battery, store).front().table;
  ASSERT_EQ(cells.rows.size(), battery.cells().size());
  EXPECT_DOUBLE_EQ(std::get<Estimate>(cells.rows.front()[4]).value, 30.0);
  EXPECT_EQ(std::get<std::int64_t>(cells.rows.back()[3]), 3);
}

TEST_F(Summary, RelatesATeamToAsManySingleRobots) {
  const Table improvement = summarize(battery, store).at(1).table;
  // Two robots of the first learner reach 60 - 1/6, one reaches 30.
  ASSERT_EQ(improvement.rows.size(), 4U);
  EXPECT_NEAR(std::get<Estimate>(improvement.rows.front()[4]).value, (60.0 - 0.5 / 3) / (2 * 30.0),
              1e-12);
}

TEST_F(Summary, ComparesOnTheSameSeedsTheLaterValueLessTheEarlier) {
  const Table comparison = summarize(battery, store).at(2).table;
  // Two strategies for each of two team sizes; the percentages do not differ and are left out.
  ASSERT_EQ(comparison.rows.size(), 4U);
  for (const auto& row : comparison.rows) {
    EXPECT_EQ(std::get<std::string>(row[4]), "lm - static1");
    const auto& difference = std::get<Estimate>(row[5]);
    EXPECT_GT(difference.value, 2.5);
    EXPECT_LT(difference.value, 3.5);
  }
}

TEST_F(Summary, NamesItsTables) {
  std::vector<std::string> names;
  for (const ReportTable& each : summarize(battery, store)) {
    names.push_back(each.name);
  }
  EXPECT_EQ(names, (std::vector<std::string>{"cells", "improvement", "comparison"}));
}

TEST_F(Summary, HasNoImprovementWithoutTeamsOfOne) {
  ExperimentConfig config = small_experiment();
  config.teams = {{2, 3}};
  const auto tables = summarize(small_battery(config), store);
  ASSERT_EQ(tables.size(), 2U);
  EXPECT_EQ(tables[1].name, "comparison");
}

}  // namespace
}  // namespace tacit
