#include "deploy/experiment/runner.h"

#include <gtest/gtest.h>

#include "console/record/sha256.h"
#include "deploy/experiment/summary.h"
#include "deploy/lockstep/setup.h"
#include "deploy/lockstep/team.h"
#include "tests/experiment/small_battery.h"
#include "tests/process/programs.h"

namespace tacit {
namespace {

class RunBattery : public testing::Test {
 protected:
  const Scratch folder;
  RunStore open_store() { return RunStore(folder / "runs.db"); }
};

TEST_F(RunBattery, LeavesARowPerRun) {
  const Battery battery = small_battery();
  RunStore store = open_store();
  EXPECT_TRUE(run_battery(battery, store, {2, {}, nullptr}));
  for (const PlannedRun& run : battery.runs()) {
    const auto row = store.find(run.key);
    ASSERT_TRUE(row);
    EXPECT_TRUE(row->outcome.complete);
    EXPECT_EQ(row->outcome.ticks, 200U);
    EXPECT_EQ(row->facts.seed, run.seed);
  }
}

TEST_F(RunBattery, MakesOnlyTheMissingRunsTheNextTime) {
  const Battery battery = small_battery();
  RunStore store = open_store();
  std::atomic<bool> stop = false;
  const auto stop_after_five = [&stop](const BatteryProgress& p) { stop = p.done >= 5; };
  EXPECT_FALSE(run_battery(battery, store, {1, stop_after_five, &stop}));
  EXPECT_EQ(store.size(), 5U);
  BatteryProgress last;
  EXPECT_TRUE(run_battery(battery, store, {2, [&](const BatteryProgress& p) { last = p; }, {}}));
  EXPECT_EQ(last.resumed, 5U);
  EXPECT_EQ(last.done, battery.runs().size());
  EXPECT_EQ(last.ticks, (battery.runs().size() - 5) * 200);
}

TEST_F(RunBattery, GivesTheSameRowsWithOneWorkerAndWithThree) {
  const Battery battery = small_battery();
  RunStore one(folder / "one.db");
  RunStore three(folder / "three.db");
  EXPECT_TRUE(run_battery(battery, one, {1, {}, nullptr}));
  EXPECT_TRUE(run_battery(battery, three, {3, {}, nullptr}));
  for (const PlannedRun& run : battery.runs()) {
    EXPECT_EQ(one.find(run.key)->outcome.event_log_sha256,
              three.find(run.key)->outcome.event_log_sha256);
    EXPECT_EQ(one.find(run.key)->outcome.metrics, three.find(run.key)->outcome.metrics);
  }
}

TEST_F(RunBattery, StoresTheHashOfTheLogThatATeamGives) {
  const Battery battery = small_battery();
  const PlannedRun& run = battery.runs().back();
  const auto row = make_run(battery, run, nullptr);
  ASSERT_TRUE(row);
  ScenarioFile file =
      ScenarioFile::parse(battery.scenario(battery.cells()[run.cell], run.seed), "resolved");
  const tacit::Setup setup = read_setup(file);
  Team team(setup.world, setup.brain, seed(setup));
  std::string log;
  while (team.tick() < last_tick(setup)) {
    for (const Event& event : team.step()) {
      log += to_line(event) + '\n';
    }
  }
  log += to_line(team.ending()) + '\n';
  EXPECT_EQ(row->outcome.event_log_sha256, sha256_of_text(log));
}

/// A store filled by hand, so that every figure of the summary can be worked out on paper.
class Summary : public testing::Test {
 protected:
  const Scratch folder;
  Summary() {
    for (const PlannedRun& run : battery.runs()) {
      const Cell& cell = battery.cells()[run.cell];
      const double learner = cell.levels[0].value == "lm" ? 3.0 : 0.0;
      // Of no effect on a mean over two seeds, and other for one learner than for the other.
      const double chance = (run.seed % 2 == 0 ? 0.5 : -0.5) * (learner > 0 ? 0.9 : 1.0);
      RunRow row;
      row.facts.key = run.key;
      row.outcome.complete = true;
      row.outcome.metrics = {
          {"mean_death_distance_m", 30.0 * static_cast<double>(cell.robots) + learner + chance},
          {"intercept_percent", 100.0}};
      store.add(row);
    }
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
