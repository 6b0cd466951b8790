#include <gtest/gtest.h>

#include <csignal>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "console/record/run_store.h"
#include "tests/process/programs.h"

namespace tacit {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

/// Two foragers, few ticks.
std::vector<std::string> words(const std::vector<std::string>& more, const char* seed = "5") {
  std::vector<std::string> words{"learn",   "forage", "--robots",         "2", "--seed", seed,
                                 "--quiet", "--set",  "end.cap_ticks=200"};
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

std::string policies(const fs::path& folder) {
  return text_of(folder / "robot_1.json") + text_of(folder / "robot_2.json");
}

TEST(Learn, PrintsExactlyOneObjectWithJson) {
  const Finished finished = tacit(words({"--episodes", "3", "--evaluate", "2", "--json"}));
  const json result = json::parse(finished.out, nullptr, false);
  ASSERT_TRUE(result.is_object()) << finished.out << finished.err;
  EXPECT_EQ(result["seed"], 5);
  EXPECT_EQ(result["episodes"], 3);
  EXPECT_EQ(result["evaluate"], 2);
  EXPECT_EQ(result["event_log_sha256"].get<std::string>().size(), 64U);
  EXPECT_TRUE(result["policy_dir"].is_null());
}

TEST(Learn, GivesTheRowThatAnExperimentHasForTheSameChain) {
  const Scratch scratch;
  std::ofstream(scratch / "one.toml")
      << "[experiment]\nname = \"one\"\nscenario = \"forage\"\n"
         "settings = [\"end.cap_ticks = 200\"]\nteams = [[2, 1]]\nfirst_seed = 5\n"
         "episodes = 3\nevaluate = 2\nmeasures = [\"score_ticks\"]\n";
  const Finished experiment =
      tacit({"experiment", scratch / "one.toml", "--quiet", "--json", "--out", scratch / "out"});
  ASSERT_EQ(experiment.exit_code, 0) << experiment.err;
  const RunStore store(scratch / "out/runs.db");
  ASSERT_EQ(store.size(), 1U);
  const RunRow row = store.find(store.finished_keys().front()).value();

  const Finished learn = tacit(words({"--episodes", "3", "--evaluate", "2", "--json"}));
  const json result = json::parse(learn.out);
  EXPECT_EQ(result["event_log_sha256"], row.outcome.event_log_sha256);
  for (const RecordedMetric& metric : row.outcome.metrics) {
    const auto value = row.outcome.metric(metric.key);
    EXPECT_EQ(result["metrics"].at(metric.key), value ? json(*value) : json()) << metric.key;
  }
}

TEST(Learn, TakenUpAgainGoesOnAsIfNeverStopped) {
  const Scratch scratch;
  const fs::path whole = scratch / "whole";
  const fs::path parts = scratch / "parts";
  EXPECT_EQ(tacit(words({"--episodes", "3", "--policy", whole})).exit_code, 0);
  EXPECT_EQ(tacit(words({"--episodes", "2", "--policy", parts})).exit_code, 0);
  EXPECT_NE(policies(whole), policies(parts));
  EXPECT_EQ(tacit(words({"--episodes", "1", "--policy", parts}, "7")).exit_code, 0);
  EXPECT_EQ(policies(whole), policies(parts));
}

TEST(Learn, TellsAboutEveryRun) {
  const Finished finished =
      tacit({"learn", "forage", "--robots", "2", "--episodes", "2", "--set", "end.cap_ticks=200"});
  EXPECT_NE(finished.err.find("run 1/2  seed "), std::string::npos) << finished.err;
  EXPECT_NE(finished.err.find("run 2/2  seed "), std::string::npos);
  EXPECT_NE(finished.out.find("first"), std::string::npos);
}

TEST(Learn, RefusesPoliciesOfAnotherTeamBeforeAnything) {
  const Scratch scratch;
  const fs::path folder = scratch / "policies";
  EXPECT_EQ(tacit(words({"--episodes", "1", "--policy", folder})).exit_code, 0);
  const Finished finished =
      tacit({"learn", "forage", "--robots", "3", "--policy", folder, "--out", scratch / "out"});
  EXPECT_EQ(finished.exit_code, 2);
  EXPECT_FALSE(fs::exists(scratch / "out"));
}

TEST(Learn, KeepsWhatFinishedRunsTaughtWhenInterrupted) {
  const Scratch scratch;
  const fs::path folder = scratch / "policies";
  Running running(tacit_words(words({"--episodes", "100000", "--policy", folder})));
  ASSERT_TRUE(becomes_true([&] { return fs::exists(folder / "robot_2.json"); }));
  running.send(SIGINT);
  const Finished finished = running.finish();
  EXPECT_EQ(finished.exit_code, 130);
  EXPECT_NE(finished.err.find("go on with --seed"), std::string::npos) << finished.err;
}

}  // namespace
}  // namespace tacit
