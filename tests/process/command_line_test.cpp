#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "tests/process/programs.h"

namespace tacit {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

/// A short run in one process.
Finished short_run(const fs::path& out, const std::vector<std::string>& more = {}) {
  std::vector<std::string> words{"run",     "guard",         "--duration", "30",
                                 "--quiet", "--one-process", "--out",      out};
  words.insert(words.end(), more.begin(), more.end());
  return tacit(words);
}

TEST(CommandLine, PrintsExactlyOneObjectWithJson) {
  const Scratch scratch;
  const Finished finished = short_run(scratch / "run", {"--json", "--seed", "7"});
  const json summary = json::parse(finished.out, nullptr, false);
  ASSERT_TRUE(summary.is_object()) << finished.out;
  EXPECT_EQ(summary["scenario"], "guard");
  EXPECT_EQ(summary["seed"], 7);
  EXPECT_EQ(summary["transport"], "one-process");
  EXPECT_EQ(summary["ticks"], 300);
  EXPECT_EQ(summary["event_log_sha256"].get<std::string>().size(), 64U);
  EXPECT_TRUE(summary["metrics"].contains("mean_death_distance_m"));
  for (const char* key :
       {"version", "wall_s", "ticks_per_s", "run_dir", "complete", "repeatable"}) {
    EXPECT_TRUE(summary.contains(key)) << key;
  }
}

TEST(CommandLine, WritesTheScenarioAsResolved) {
  const Scratch scratch;
  (void)short_run(scratch / "run", {"--robots", "3", "--set", "enemies.speed_mps=1.25"});
  const std::string scenario = text_of(scratch / "run/scenario.toml");
  EXPECT_NE(scenario.find("\ncount = 3\n"), std::string::npos);
  EXPECT_NE(scenario.find("\nspeed_mps = 1.25\n"), std::string::npos);
}

TEST(CommandLine, RunsItsOwnResolvedScenarioToTheSameLog) {
  const Scratch scratch;
  (void)short_run(scratch / "first", {"--seed", "9", "--learner", "static1"});
  const Finished again = tacit({"run", scratch / "first/scenario.toml", "--one-process", "--quiet",
                                "--out", scratch / "second"});
  EXPECT_EQ(again.exit_code, 0) << again.err;
  EXPECT_EQ(text_of(scratch / "first/events.jsonl"), text_of(scratch / "second/events.jsonl"));
  EXPECT_EQ(text_of(scratch / "first/scenario.toml"), text_of(scratch / "second/scenario.toml"));
}

TEST(CommandLine, KeepsToTheSpeedThatIsAskedFor) {
  const Scratch scratch;
  const Finished finished = tacit({"run", "guard", "--duration", "10", "--speed", "10", "--quiet",
                                   "--one-process", "--json", "--out", scratch / "run"});
  EXPECT_GE(json::parse(finished.out)["wall_s"].get<double>(), 0.95);
}

TEST(CommandLine, EndsWithFourWhenTheTimeIsOut) {
  const Scratch scratch;
  const Finished finished = tacit({"run", "guard", "--speed", "1", "--timeout", "0.5", "--quiet",
                                   "--one-process", "--json", "--out", scratch / "run"});
  EXPECT_EQ(finished.exit_code, 4);
  EXPECT_EQ(json::parse(finished.out)["complete"], false);
}

TEST(CommandLine, ExplainsEveryParameter) {
  const Finished finished = tacit({"scenarios", "--explain"});
  EXPECT_EQ(finished.exit_code, 0);
  for (const char* part : {"[robots]", "max_speed_mps", "m/s", "[paper]", "linking_distance_m"}) {
    EXPECT_NE(finished.out.find(part), std::string::npos) << part;
  }
}

TEST(CommandLine, HintsAtTheNearestCommand) {
  const Finished finished = tacit({"rum"});
  EXPECT_EQ(finished.exit_code, 2);
  EXPECT_NE(finished.err.find("no command \"rum\", did you mean \"run\"?"), std::string::npos)
      << finished.err;
}

TEST(CommandLine, ListsTheScenarios) {
  const Finished finished = tacit({"scenarios"});
  EXPECT_NE(finished.out.find("guard "), std::string::npos);
  EXPECT_EQ(finished.out.find("broken"), std::string::npos) << finished.out;
}

class Help : public testing::TestWithParam<const char*> {};

TEST_P(Help, HasAnExample) {
  const Finished finished = tacit({GetParam(), "--help"});
  EXPECT_EQ(finished.exit_code, 0);
  EXPECT_NE(finished.out.find("Example"), std::string::npos);
}

INSTANTIATE_TEST_SUITE_P(Commands, Help,
                         testing::Values("run", "learn", "scenarios", "verify", "debrief",
                                         "operate", "doctor", "experiment", "map"));

class Interface : public testing::TestWithParam<const char*> {};

TEST_P(Interface, NamesTopics) {
  const Finished finished = Running({program(GetParam()), "--interface"}).finish();
  EXPECT_EQ(finished.exit_code, 0);
  EXPECT_NE(finished.out.find("tacit/"), std::string::npos);
}

INSTANTIATE_TEST_SUITE_P(Programs, Interface,
                         testing::Values("world_server", "robot_agent", "console"));

TEST(Verify, PassesARunThatIsAsItWas) {
  const Scratch scratch;
  (void)short_run(scratch / "run");
  const Finished finished = tacit({"verify", scratch / "run"});
  EXPECT_EQ(finished.exit_code, 0) << finished.out << finished.err;
}

/// Puts `to` in place of the first `from` after `start` in a file.
void change(const fs::path& file, const std::string& start, const std::string& from,
            const std::string& to) {
  std::string text = text_of(file);
  text.replace(text.find(from, text.find(start)), from.size(), to);
  std::ofstream(file, std::ios::binary) << text;
}

TEST(Verify, NamesTheFirstLineThatHasBeenChanged) {
  const Scratch scratch;
  (void)short_run(scratch / "run");
  change(scratch / "run/events.jsonl", "\n", "\"tick\":", "\"tick\":9");
  const Finished finished = tacit({"verify", scratch / "run"});
  EXPECT_EQ(finished.exit_code, 5);
  EXPECT_NE(finished.out.find("part at line 2, tick"), std::string::npos) << finished.out;
}

TEST(Verify, FindsALogThatEndsTooSoon) {
  const Scratch scratch;
  (void)short_run(scratch / "run");
  const fs::path log = scratch / "run/events.jsonl";
  fs::resize_file(log, text_of(log).find('\n') + 1);
  const Finished finished = tacit({"verify", scratch / "run"});
  EXPECT_EQ(finished.exit_code, 5);
  EXPECT_NE(finished.out.find("(the log ends)"), std::string::npos) << finished.out;
}

TEST(Verify, SaysWhenARunIsMarkedAsNotRepeatable) {
  const Scratch scratch;
  (void)short_run(scratch / "run");
  change(scratch / "run/metrics.json", "\"repeatable\"", "true", "false");
  const Finished finished = tacit({"verify", scratch / "run"});
  EXPECT_EQ(finished.exit_code, 5);
  EXPECT_NE(finished.out.find("not repeatable"), std::string::npos) << finished.out;
}

TEST(Verify, RefusesWhatIsNoRunDirectory) {
  const Scratch scratch;
  EXPECT_EQ(tacit({"verify", scratch / "nothing"}).exit_code, 2);
}

}  // namespace
}  // namespace tacit
