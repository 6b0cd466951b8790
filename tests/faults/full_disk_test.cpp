#include <gtest/gtest.h>
#include <sys/resource.h>

#include "console/record/run_directory.h"
#include "tests/faults/live_run.h"

namespace tacit {
namespace {

/// No file of the process may become larger than its event log is now, and some.
void fill_disk_for(pid_t console, const std::string& events) {
  const rlimit limit{events.size() + 2000, RLIM_INFINITY};
  ASSERT_EQ(prlimit(console, RLIMIT_FSIZE, &limit, nullptr), 0);
}

TEST(FullDisk, EndsARunOverDdsWithOneAndAMessage) {
  LiveRun run;
  fill_disk_for(run.console(), run.events());
  const Finished finished = run.launcher().finish();
  EXPECT_EQ(finished.exit_code, 1) << finished.err;
  EXPECT_NE(finished.err.find("events.jsonl: "), std::string::npos) << finished.err;
  EXPECT_TRUE(run.events().ends_with('\n'));
}

TEST(FullDisk, EndsARunInOneProcessWithOneAndAMessage) {
  const Scratch scratch;
  Limits limits;
  // More than the run store needs to begin with, less than the event log comes to.
  limits.largest_file = 40000;
  const Finished finished = tacit({"run", "guard", "--one-process", "--quiet", "--out",
                                   scratch / "run", "--store", scratch / "runs.db"},
                                  limits);
  EXPECT_EQ(finished.exit_code, 1) << finished.err;
  EXPECT_NE(finished.err.find("events.jsonl: "), std::string::npos) << finished.err;
  EXPECT_TRUE(text_of(scratch / "run/events.jsonl").ends_with('\n'));
}

}  // namespace
}  // namespace tacit
