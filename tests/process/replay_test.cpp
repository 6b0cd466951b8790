#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>

#include "tests/process/programs.h"

namespace tacit {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

Finished run(const fs::path& out, const std::vector<std::string>& more, const Limits& limits = {}) {
  std::vector<std::string> words{"run", "guard",   "--duration", "120",   "--seed",
                                 "7",   "--quiet", "--json",     "--out", out};
  words.insert(words.end(), more.begin(), more.end());
  return tacit(words, limits);
}

json info_of(const fs::path& file) {
  return json::parse(tacit({"replay", file, "--info", "--json"}).out, nullptr, false);
}

class Recorded : public testing::TestWithParam<bool> {
 protected:
  [[nodiscard]] static std::vector<std::string> words(std::vector<std::string> more) {
    if (GetParam()) more.emplace_back("--one-process");
    return more;
  }
};

TEST_P(Recorded, RunGivesItsEventLogBackLineByLine) {
  const Scratch scratch;
  ASSERT_EQ(run(scratch / "run", words({"--record"})).exit_code, 0);
  const Finished replayed = tacit({"replay", scratch / "run/run.mcap", "--events"});
  EXPECT_EQ(replayed.exit_code, 0) << replayed.err;
  EXPECT_EQ(replayed.out, text_of(scratch / "run/events.jsonl"));
}

TEST_P(Recorded, RunHasTheEventLogOfOneThatIsNot) {
  const Scratch scratch;
  const json with = json::parse(run(scratch / "with", words({"--record"})).out);
  const json without = json::parse(run(scratch / "without", words({})).out);
  EXPECT_EQ(with["event_log_sha256"], without["event_log_sha256"]);
  EXPECT_FALSE(fs::exists(scratch / "without/run.mcap"));
}

TEST_P(Recorded, RunIsToldWhole) {
  const Scratch scratch;
  const json summary = json::parse(run(scratch / "run", words({"--record"})).out);
  const json info = info_of(scratch / "run");
  ASSERT_TRUE(info.is_object());
  EXPECT_EQ(info["trouble"], "");
  EXPECT_EQ(info["event_log_sha256"], summary["event_log_sha256"]);
  EXPECT_EQ(info["metadata"]["run"]["seed"], "7");
  EXPECT_EQ(info["metadata"]["outcome"]["complete"], "true");
  EXPECT_EQ(info["end_s"], 120.0);
  EXPECT_EQ(info["attachments"]["scenario.toml"], fs::file_size(scratch / "run/scenario.toml"));
  EXPECT_GT(info["channels"]["/tacit/status"], 0);
}

TEST_P(Recorded, RunWithTrajectoriesHasThePosesOfEveryTick) {
  const Scratch scratch;
  ASSERT_EQ(run(scratch / "run", words({"--record", "--trajectories"})).exit_code, 0);
  EXPECT_EQ(tacit({"replay", scratch / "run", "--csv"}).out,
            text_of(scratch / "run/trajectories.csv"));
}

INSTANTIATE_TEST_SUITE_P(Transport, Recorded, testing::Values(false, true),
                         [](const testing::TestParamInfo<bool>& it) {
                           return it.param ? "OneProcess" : "Dds";
                         });

TEST(Record, LeavesTheRunAloneWhenTheDiskIsFull) {
  const Scratch scratch;
  const Finished finished = run(scratch / "run", {"--one-process", "--record"}, {150'000});
  EXPECT_EQ(finished.exit_code, 0) << finished.err;
  EXPECT_EQ(json::parse(finished.out)["complete"], true);
  EXPECT_NE(finished.err.find("the recording ends here"), std::string::npos) << finished.err;
  EXPECT_NE(info_of(scratch / "run")["trouble"], "");
}

TEST(Record, IsRefusedOverAFileThatIsThereAndForAnotherKindOfFile) {
  const Scratch scratch;
  std::ofstream(scratch / "old.mcap") << "somebody's";
  const Finished there = run(scratch / "a", {"--one-process", "--record", scratch / "old.mcap"});
  EXPECT_EQ(there.exit_code, 2);
  EXPECT_NE(there.err.find("is there already"), std::string::npos) << there.err;
  const Finished other = run(scratch / "b", {"--one-process", "--record", "tape.bag"});
  EXPECT_EQ(other.exit_code, 2);
  EXPECT_NE(other.err.find("wanted a file that ends in .mcap"), std::string::npos) << other.err;
  EXPECT_FALSE(fs::exists(scratch / "b"));
}

TEST(Replay, ReadsAFileThatIsCutOff) {
  const Scratch scratch;
  const fs::path file = scratch / "tape.mcap";
  ASSERT_EQ(run(scratch / "run", {"--one-process", "--record", file}).exit_code, 0);
  fs::resize_file(file, fs::file_size(file) - 1000);
  const Finished events = tacit({"replay", file, "--events"});
  EXPECT_EQ(events.exit_code, 0);
  EXPECT_NE(events.err.find("the file is not whole"), std::string::npos) << events.err;
  EXPECT_TRUE(text_of(scratch / "run/events.jsonl").starts_with(events.out));
  EXPECT_NE(info_of(file)["trouble"], "");
}

TEST(Replay, RefusesWhatIsNoRecording) {
  const Scratch scratch;
  ASSERT_EQ(run(scratch / "run", {"--one-process"}).exit_code, 0);
  const Finished none = tacit({"replay", scratch / "run"});
  EXPECT_EQ(none.exit_code, 2);
  const Finished log = tacit({"replay", scratch / "run/events.jsonl"});
  EXPECT_EQ(log.exit_code, 2);
  EXPECT_NE(log.err.find("is no MCAP file"), std::string::npos) << log.err;
}

}  // namespace
}  // namespace tacit
