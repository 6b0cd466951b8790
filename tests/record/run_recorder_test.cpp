#include "console/record/run_recorder.h"

#include "console/record/record_error.h"
#include "tests/record/events.h"
#include "tests/record/scratch.h"

namespace tacit {
namespace {

class RunRecorderTest : public ScratchTest {
 protected:
  RunRecorder fresh() { return RunRecorder(RunDirectory::create(run, RunFacts(), "")); }
  RunRecorder again() { return RunRecorder(RunDirectory::open(run)); }

  const std::filesystem::path run = folder / "run";
  const std::vector<Event> events = a_run();
  const std::span<const Event> all{events};
};

TEST_F(RunRecorderTest, ACompleteRunHasItsMetricsAndHash) {
  RunRecorder recorder = fresh();
  recorder.add(all);
  const RunOutcome outcome = recorder.finish(2.0);

  EXPECT_TRUE(outcome.complete);
  EXPECT_TRUE(outcome.repeatable);
  EXPECT_EQ(outcome.ticks, 150);
  EXPECT_EQ(outcome.ticks_per_s(), 75.0);
  EXPECT_EQ(outcome.metric("mean_death_distance_m"), 31.5);
  EXPECT_EQ(outcome.event_log_sha256, sha256_of_text(lines_of(events)));
  EXPECT_EQ(RunDirectory::open(run).outcome(), outcome);
}

TEST_F(RunRecorderTest, ARunCutShortIsIncomplete) {
  RunRecorder recorder = fresh();
  recorder.add(all.first(4));
  const RunOutcome outcome = recorder.finish(2.0);

  EXPECT_FALSE(outcome.complete);
  EXPECT_EQ(outcome.incomplete_because, "the end of the run was not recorded");
  EXPECT_EQ(outcome.ticks, 90);
}

TEST_F(RunRecorderTest, ARunInTroubleIsIncompleteAlsoAtItsEnd) {
  RunRecorder recorder = fresh();
  recorder.add(all);
  const RunOutcome outcome = recorder.finish(2.0, "a disk failed");

  EXPECT_FALSE(outcome.complete);
  EXPECT_EQ(outcome.incomplete_because, "a disk failed");
}

TEST_F(RunRecorderTest, ARunThatLostARobotIsNotRepeatable) {
  RunRecorder recorder = fresh();
  recorder.add(std::vector<Event>{{1, RobotLost{}}, {2, RobotBack{}}, {3, RunEnded{}}});

  EXPECT_FALSE(recorder.finish(1.0).repeatable);
}

TEST_F(RunRecorderTest, PassesOverEventsThatComeTwice) {
  RunRecorder recorder = fresh();
  recorder.add(0, all.first(4));
  recorder.add(1, all.subspan(1, 2));
  recorder.add(2, all.subspan(2));

  EXPECT_EQ(text_of(run / "events.jsonl"), lines_of(events));
  EXPECT_EQ(recorder.tally().of<Enemies>().created, 1);
}

TEST_F(RunRecorderTest, SaysWhichEventIsMissing) {
  RunRecorder recorder = fresh();
  recorder.add(0, all.first(2));

  EXPECT_EQ(complaint<RecordError>([&] { recorder.add(4, all.subspan(4)); }),
            (run / "events.jsonl").string() + ": event 4 came, but event 2 is missing");
}

TEST_F(RunRecorderTest, ARestartAtAnyEventGivesTheSameFiles) {
  RunRecorder whole = fresh();
  whole.add(all);
  const RunOutcome wanted = whole.finish(2.0);
  for (std::size_t before = 0; before <= events.size(); ++before) {
    const auto path = folder / ("run" + std::to_string(before));
    RunRecorder(RunDirectory::create(path, RunFacts(), "")).add(all.first(before));
    RunRecorder recorder(RunDirectory::open(path));
    recorder.add(all);

    ASSERT_EQ(recorder.finish(2.0), wanted) << before;
    ASSERT_EQ(text_of(path / "events.jsonl"), lines_of(events)) << before;
  }
}

TEST_F(RunRecorderTest, ARestartThatDoesNotHearAllAgainIsIncomplete) {
  fresh().add(all);
  RunRecorder recorder = again();
  recorder.add(all.first(2));
  const RunOutcome outcome = recorder.finish(1.0);

  EXPECT_FALSE(outcome.complete);
  EXPECT_EQ(outcome.event_log_sha256, sha256_of_text(lines_of(events)));
}

TEST_F(RunRecorderTest, WritesTrajectoriesOnlyWhenAsked) {
  WorldView view;
  view.robots.push_back({RobotId{1}, {}, {}, true});
  RunRecorder plain = fresh();
  plain.add(view);
  RunRecorder asked(RunDirectory::create(folder / "asked", RunFacts(), ""),
                    RunRecorder::Trajectories::On);
  asked.add(view);

  EXPECT_FALSE(std::filesystem::exists(run / "trajectories.csv"));
  EXPECT_EQ(text_of(folder / "asked" / "trajectories.csv"),
            "tick,id,kind,x_m,y_m,heading_rad\n0,1,robot,0,0,0\n");
}

TEST_F(RunRecorderTest, ItsRowNamesTheRunDirectory) {
  RunRecorder recorder = fresh();
  const RunOutcome outcome = recorder.finish(1.0);
  const RunRow row = recorder.row(outcome);

  EXPECT_EQ(row.run_dir, run.string());
  EXPECT_EQ(row.facts, recorder.directory().facts());
  EXPECT_EQ(row.outcome, outcome);
}

}  // namespace
}  // namespace tacit
