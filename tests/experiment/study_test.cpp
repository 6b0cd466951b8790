#include <gtest/gtest.h>

#include <algorithm>
#include <optional>

#include "console/report/exponential.h"
#include "deploy/experiment/summary.h"
#include "tests/experiment/small_battery.h"
#include "tests/process/programs.h"

namespace tacit {
namespace {

constexpr double kA = 900.0;
constexpr double kB = 0.4;
constexpr double kC = 100.0;

/// Two environments, two variants, five team sizes, chains of four runs of which two count.
ExperimentConfig a_study() {
  ExperimentConfig config;
  config.name = "study";
  config.scenarios = {"guard", "crowd"};
  config.settings = {"obstacles.coverage_percent = 0"};
  config.variants = {"x: enemies.speed_mps = 1.5", "y: enemies.speed_mps = 2.0"};
  config.teams = {{2, 3}, {4, 3}, {6, 3}, {8, 3}, {12, 3}};
  config.episodes = 4;
  config.evaluate = 2;
  config.measures = {"score_ticks"};
  return config;
}

/// A decay with the team's size; the second variant is 10 higher, the second environment 60; every
/// run of a chain is 50 lower than the one before.
std::vector<RecordedMetric> score(const Cell& cell, std::int64_t seed) {
  const double chance = static_cast<double>(seed % 8) * (cell.robots % 4 == 0 ? 0.5 : -0.5);
  const double last = kA * exponential(-kB * static_cast<double>(cell.robots)) + kC +
                      (cell.level("variant") == "y" ? 10.0 + 0.1 * chance : 0.0) +
                      (cell.level("scenario") == "crowd" ? 60.0 : 0.0) + chance;
  std::vector<RecordedMetric> metrics{{"score_ticks", last}, {"failed", 0.0}};
  for (int run = 1; run <= 4; ++run) {
    metrics.push_back(
        {"score_ticks_" + std::to_string(run), last + 50.0 * (4 - run) + 0.1 * chance * run});
  }
  return metrics;
}

class Study : public testing::Test {
 protected:
  Study() { fill(store, battery, battery.runs(), score); }

  [[nodiscard]] std::optional<Table> table(const std::string& name) const {
    for (const ReportTable& each : summarize(battery, store)) {
      if (each.name == name) {
        return each.table;
      }
    }
    return std::nullopt;
  }

  const Scratch folder;
  const Battery battery = small_battery(a_study());
  RunStore store{folder / "runs.db"};
};

const std::vector<TableCell>& row_of(const Table& table, const std::string& name) {
  return *std::find_if(table.rows.begin(), table.rows.end(),
                       [&name](const auto& row) { return row[0] == TableCell{name}; });
}

TEST_F(Study, TabulatesHowOftenChainsFailed) {
  EXPECT_EQ(table("cells").value().columns.back().key, "failed");
}

TEST_F(Study, AveragesEachTeamSizePerVariantAndOverAll) {
  const Table sizes = table("team_size").value();
  ASSERT_EQ(sizes.rows.size(), 3U * 5U);
  EXPECT_EQ(std::get<std::int64_t>(row_of(sizes, "all")[2]), 12);
  const double x = std::get<double>(row_of(sizes, "x")[3]);
  const double y = std::get<double>(row_of(sizes, "y")[3]);
  EXPECT_NEAR(std::get<double>(row_of(sizes, "all")[3]), (x + y) / 2.0, 1e-9);
}

TEST_F(Study, GivesTheRangeOfTheVariants) {
  const Table sizes = table("team_size").value();
  const auto& all = row_of(sizes, "all");
  EXPECT_EQ(all[5], row_of(sizes, "x")[3]);
  EXPECT_EQ(all[6], row_of(sizes, "y")[3]);
}

TEST_F(Study, FindsTheDecay) {
  const Table fits = table("fit").value();
  ASSERT_EQ(fits.rows.size(), 3U);
  EXPECT_NEAR(std::get<Estimate>(row_of(fits, "all")[2]).value, kB, 0.02);
  EXPECT_NEAR(std::get<Estimate>(row_of(fits, "y")[3]).value, kC + 10.0 + 30.0, 4.0);
  EXPECT_EQ(std::get<std::string>(row_of(fits, "all").back()), "decay");
}

TEST_F(Study, TellsVariantsApart) {
  const Table variants = table("variants").value();
  ASSERT_EQ(variants.rows.size(), 1U);
  EXPECT_EQ(std::get<std::string>(variants.rows[0][0]), "y - x");
  EXPECT_EQ(std::get<std::int64_t>(variants.rows[0][1]), 30);
  EXPECT_NEAR(std::get<Estimate>(variants.rows[0][2]).value, 10.0, 0.2);
}

TEST_F(Study, ShowsThatTheVariantMattersLessThanTheTeamSize) {
  const Table effects = table("effects").value();
  const double robots = std::get<double>(row_of(effects, "robots")[1]);
  const double variant = std::get<double>(row_of(effects, "variant")[1]);
  const double scenario = std::get<double>(row_of(effects, "scenario")[1]);
  const double residual = std::get<double>(row_of(effects, "residual")[1]);
  EXPECT_GT(robots, 50.0 * variant);
  EXPECT_NEAR(robots + variant + scenario + residual, 1.0, 1e-9);
}

TEST_F(Study, FollowsTheScoreFromRunToRun) {
  const Table curve = table("curve").value();
  ASSERT_EQ(curve.rows.size(), 2U * 5U * 4U);
  const double first = std::get<Estimate>(curve.rows[0][4]).value;
  EXPECT_NEAR(first - std::get<Estimate>(curve.rows[3][4]).value, 150.0, 2.0);
}

TEST_F(Study, ComparesTheLastRunsOfAChainWithItsFirst) {
  const Table learned = table("learned").value();
  ASSERT_EQ(learned.rows.size(), 2U * 5U);
  // The means of runs 3 and 4 less those of 1 and 2.
  EXPECT_NEAR(std::get<Estimate>(learned.rows[0][5]).value, -100.0, 2.0);
  EXPECT_LT(std::get<double>(learned.rows[0][8]), 0.001);
}

TEST_F(Study, DrawsTeamSizesAndTheCurve) {
  const std::vector<ReportFigure> figures = draw(battery, store);
  ASSERT_EQ(figures.size(), 2U);
  EXPECT_EQ(figures[0].name, "team_size");
  EXPECT_EQ(figures[1].name, "curve");
  for (const ReportFigure& figure : figures) {
    EXPECT_EQ(figure.svg.find("<svg"), 0U);
  }
}

TEST_F(Study, DrawsNothingWithoutAScore) {
  RunStore empty(folder / "empty.db");
  EXPECT_TRUE(draw(battery, empty).empty());
}

TEST_F(Study, LeavesTeamSizesOutWhereParametersVary) {
  ExperimentConfig config = a_study();
  config.variants.clear();
  config.factors = {"enemies.speed_mps = 1.5, 2.0"};
  const Battery other = small_battery(config);
  for (const ReportTable& each : summarize(other, store)) {
    EXPECT_NE(each.name, "team_size");
  }
}

}  // namespace
}  // namespace tacit
