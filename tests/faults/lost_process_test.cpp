#include <gtest/gtest.h>
#include <sys/prctl.h>

#include <chrono>
#include <csignal>
#include <nlohmann/json.hpp>

#include "console/record/run_directory.h"
#include "console/record/run_store.h"
#include "idl/bus/leftovers.h"
#include "tests/faults/live_run.h"

namespace tacit {
namespace {

using Clock = std::chrono::steady_clock;
using nlohmann::json;

/// Under a sanitizer everything takes longer, the kernel's own part excepted.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr double kTwoSeconds = 4.0;
#else
constexpr double kTwoSeconds = 2.0;
#endif

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

bool any_alive(const std::vector<pid_t>& pids) {
  return std::any_of(pids.begin(), pids.end(), is_alive);
}

TEST(KilledAgent, IsStartedAgainAndCarriesOn) {
  LiveRun run;
  const pid_t before = run.agent(2);
  kill(before, SIGKILL);
  const Finished finished = run.launcher().finish();
  EXPECT_EQ(finished.exit_code, 0) << finished.err;
  EXPECT_TRUE(contains(finished.err, "robot_agent 2 was killed by signal 9")) << finished.err;
  EXPECT_TRUE(contains(run.events(), "\"event\":\"robot_lost\",\"robot\":2"));
  EXPECT_TRUE(contains(run.events(), "\"event\":\"robot_back\",\"robot\":2"));
}

TEST(KilledAgent, MarksTheRunAsNotRepeatableInItsMetricsAndItsStoreRow) {
  LiveRun run;
  kill(run.agent(1), SIGKILL);
  const Finished finished = run.launcher().finish();
  const json summary = json::parse(finished.out);
  EXPECT_EQ(summary["complete"], true) << finished.err;
  EXPECT_EQ(summary["repeatable"], false);
  const RunDirectory directory = RunDirectory::open(run.directory());
  EXPECT_FALSE(directory.outcome()->repeatable);
  EXPECT_FALSE(RunStore(run.store()).find(directory.facts().key)->outcome.repeatable);
}

TEST(LostWorld, EndsTheRunWithThreeAndLeavesARecordThatCanBeRead) {
  LiveRun run;
  const std::vector<pid_t> pids = run.children();
  kill(run.world(), SIGKILL);
  const Finished finished = run.launcher().finish();
  EXPECT_EQ(finished.exit_code, 3);
  EXPECT_TRUE(contains(finished.err, "the world server was killed by signal 9")) << finished.err;
  EXPECT_FALSE(any_alive(pids));
  EXPECT_TRUE(leftovers(run.run_nonce()).empty());
  const auto outcome = RunDirectory::open(run.directory()).outcome();
  ASSERT_TRUE(outcome);
  EXPECT_FALSE(outcome->complete);
  EXPECT_GT(outcome->events, 0U);
  EXPECT_TRUE(run.events().ends_with('\n'));
}

TEST(KilledConsole, IsStartedAgainAndTheLogIsComplete) {
  LiveRun run;
  kill(run.console(), SIGKILL);
  const Finished finished = run.launcher().finish();
  EXPECT_EQ(finished.exit_code, 0) << finished.err;
  const json summary = json::parse(finished.out);
  EXPECT_EQ(summary["complete"], true);
  EXPECT_EQ(summary["repeatable"], true);
  EXPECT_EQ(summary["event_log_sha256"], undisturbed_sha256());
}

TEST(KilledConsole, LeavesItsRecordingBesideTheNextOne) {
  LiveRun run({"--record"});
  const std::filesystem::path folder = run.directory();
  ASSERT_TRUE(becomes_true([&] { return std::filesystem::exists(folder / "run.mcap"); }));
  kill(run.console(), SIGKILL);
  const Finished finished = run.launcher().finish();
  EXPECT_EQ(finished.exit_code, 0) << finished.err;
  EXPECT_EQ(tacit({"replay", folder / "run.mcap", "--events"}).out, run.events());
  EXPECT_EQ(tacit({"replay", folder / "run.1.mcap"}).exit_code, 0);
}

class Interrupt : public testing::TestWithParam<int> {};

TEST_P(Interrupt, EndsAllWithinTwoSecondsAndLeavesNothingBehind) {
  LiveRun run;
  const std::vector<pid_t> pids = run.children();
  const Clock::time_point begin = Clock::now();
  run.launcher().send(GetParam());
  const Finished finished = run.launcher().finish();
  EXPECT_LT(std::chrono::duration<double>(Clock::now() - begin).count(), kTwoSeconds);
  EXPECT_EQ(finished.exit_code, 130) << finished.err;
  EXPECT_EQ(pids.size(), 6U);
  EXPECT_FALSE(any_alive(pids));
  EXPECT_TRUE(leftovers(run.run_nonce()).empty());
  EXPECT_EQ(json::parse(finished.out)["complete"], false);
}

INSTANTIATE_TEST_SUITE_P(Signals, Interrupt, testing::Values(SIGINT, SIGTERM));

TEST(KilledLauncher, TakesItsChildrenWithIt) {
  LiveRun run;
  const std::vector<pid_t> pids = run.children();
  run.launcher().send(SIGKILL);
  EXPECT_TRUE(becomes_true([&pids] { return !any_alive(pids); }, std::chrono::seconds(10)));
  EXPECT_TRUE(leftovers(run.run_nonce()).empty());
}

TEST(TimeOut, EndsARunOverDdsWithFour) {
  LiveRun run({"--timeout", "3"});
  const Finished finished = run.launcher().finish();
  EXPECT_EQ(finished.exit_code, 4) << finished.err;
}

/// The programs beside each other, an agent among them that always fails.
std::string programs_with_a_failing_agent(const Scratch& scratch) {
  namespace fs = std::filesystem;
  fs::copy_file(program("tacit"), scratch / "tacit");
  for (const char* name : {"world_server", "console"}) {
    fs::create_symlink(program(name), scratch / name);
  }
  fs::create_symlink("/bin/false", scratch / "robot_agent");
  return scratch / "tacit";
}

TEST(FailingAgent, EndsTheRunWithThreeAfterFiveRestarts) {
  const Scratch scratch;
  const Finished finished = Running({programs_with_a_failing_agent(scratch), "run", "guard",
                                     "--robots", "1", "--quiet", "--out", scratch / "run"})
                                .finish();
  EXPECT_EQ(finished.exit_code, 3);
  EXPECT_TRUE(contains(finished.err, "robot_agent 1 died more than 5 times in a minute"))
      << finished.err;
}

}  // namespace
}  // namespace tacit
