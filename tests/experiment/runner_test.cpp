#include "deploy/experiment/runner.h"

#include <gtest/gtest.h>

#include <set>

#include "console/record/sha256.h"
#include "deploy/experiment/selection.h"
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
  while (!team.done(last_tick(setup))) {
    for (const Event& event : team.step()) {
      log += to_line(event) + '\n';
    }
  }
  log += to_line(team.ending()) + '\n';
  EXPECT_EQ(row->outcome.event_log_sha256, sha256_of_text(log));
}

/// Chains of which the best meet a rival on other seeds.
class RunContest : public RunBattery {
 protected:
  const Battery battery = small_battery(small_contest());
  // Two cells and a rival with three chains each, then a winner and the rival with two each.
  static constexpr std::size_t kTraining = 9;
  static constexpr std::size_t kAll = 13;
};

TEST_F(RunContest, MakesTheHeldOutRunsLast) {
  RunStore store = open_store();
  std::vector<std::size_t> all;
  const auto note = [&all](const BatteryProgress& p) { all.push_back(p.all); };
  EXPECT_TRUE(run_battery(battery, store, {2, note, nullptr}));
  EXPECT_EQ(store.size(), kAll);
  EXPECT_EQ(std::set<std::size_t>(all.begin(), all.end()), (std::set<std::size_t>{kAll}));
  for (const PlannedRun& run : held_out_runs(battery, store)) {
    EXPECT_TRUE(store.find(run.key).has_value());
  }
}

TEST_F(RunContest, GoesOnWhereItWasStopped) {
  RunStore whole(folder / "whole.db");
  EXPECT_TRUE(run_battery(battery, whole, {1, {}, nullptr}));
  RunStore store = open_store();
  for (const std::size_t stop_at : {std::size_t{4}, kTraining + 1}) {
    std::atomic<bool> stop = false;
    const auto stop_there = [&](const BatteryProgress& p) { stop = p.done >= stop_at; };
    EXPECT_FALSE(run_battery(battery, store, {1, stop_there, &stop}));
    EXPECT_EQ(store.size(), stop_at);
  }
  BatteryProgress last;
  EXPECT_TRUE(run_battery(battery, store, {1, [&](const BatteryProgress& p) { last = p; }, {}}));
  EXPECT_EQ(last.resumed, kTraining + 1);
  EXPECT_EQ(store.finished_keys(), whole.finished_keys());
}

TEST_F(RunContest, KeepsNothingOfAChainThatIsStopped) {
  const std::atomic<bool> stop = true;
  EXPECT_FALSE(make_run(battery, battery.runs().front(), &stop).has_value());
}

TEST_F(RunContest, MakesRunsThatAreTheSameOnce) {
  ExperimentConfig config = small_contest();
  // The rival is the first cell by another name.
  config.rivals = {"same: enemies.speed_mps = 1.5"};
  const Battery doubled = small_battery(config);
  RunStore store = open_store();
  BatteryProgress last;
  EXPECT_TRUE(run_battery(doubled, store, {2, [&](const BatteryProgress& p) { last = p; }, {}}));
  EXPECT_EQ(last.done, last.all);
  EXPECT_EQ(last.all, store.size());
}

}  // namespace
}  // namespace tacit
