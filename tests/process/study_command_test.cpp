#include <gtest/gtest.h>

#include <algorithm>
#include <csignal>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "tests/process/programs.h"

namespace tacit {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

TEST(StudyCommand, KeepsTablesWithVersionAndSeeds) {
  const Scratch scratch;
  const Finished study = tacit({"experiment", "wizard", "--sites", "2", "--first", "4", "--robots",
                                "1", "--planners", "wizard,naive", "--out", scratch / "out"});
  ASSERT_EQ(study.exit_code, 0) << study.err;
  EXPECT_NE(study.out.find("sites 4 to 5, 4 of 4 flights"), std::string::npos) << study.out;
  EXPECT_EQ(text_of(scratch / "out" / "report.txt"), study.out);
  const json report = json::parse(text_of(scratch / "out" / "report.json"), nullptr, false);
  EXPECT_FALSE(report["version"].get<std::string>().empty());
  EXPECT_EQ(report["first_site"], 4);
  EXPECT_EQ(report["results"]["rows"].size(), 2U);
  EXPECT_EQ(report["flights"]["rows"][3]["site"], 5);
  const std::string flights = text_of(scratch / "out" / "flights.csv");
  EXPECT_EQ(std::count(flights.begin(), flights.end(), '\n'), 5);
  EXPECT_TRUE(fs::exists(scratch / "out" / "study.csv"));
  EXPECT_TRUE(fs::exists(scratch / "out" / "failures.csv"));
}

TEST(StudyCommand, TellsWhatWasFlownWhenItIsInterrupted) {
  const Scratch scratch;
  Running running(tacit_words({"experiment", "wizard", "--sites", "100000", "--robots", "1",
                               "--planners", "expert", "--out", scratch / "out"}));
  ASSERT_TRUE(becomes_true([&] { return !running.said().empty(); }));
  running.send(SIGINT);
  const Finished finished = running.finish(std::chrono::seconds(30));
  EXPECT_EQ(finished.exit_code, 130) << finished.err;
  EXPECT_NE(finished.out.find("; cut short"), std::string::npos) << finished.out;
  const json report = json::parse(text_of(scratch / "out" / "report.json"), nullptr, false);
  EXPECT_EQ(report["cut_short"], true);
}

TEST(StudyCommand, RefusesWhatMakesNoSense) {
  const Scratch scratch;
  fs::create_directories(scratch / "empty");
  const Finished caseless = tacit({"experiment", "wizard", "--seeds", scratch / "empty"});
  EXPECT_EQ(caseless.exit_code, 2);
  EXPECT_NE(caseless.err.find("found no case in"), std::string::npos) << caseless.err;
  EXPECT_EQ(tacit({"experiment", "wizard", "--sites", "0"}).exit_code, 2);
  EXPECT_EQ(tacit({"experiment", "wizard", "--robots", "11"}).exit_code, 2);
  EXPECT_EQ(tacit({"experiment", "wizard", "--planners", "oracle"}).exit_code, 2);
}

TEST(StudyCommand, LeavesExperimentsTheirName) {
  EXPECT_EQ(tacit({"experiment"}).exit_code, 2);
  const Finished unknown = tacit({"experiment", "nothing_of_that_name"});
  EXPECT_EQ(unknown.exit_code, 2);
  EXPECT_NE(unknown.err.find("nothing_of_that_name"), std::string::npos) << unknown.err;
}

}  // namespace
}  // namespace tacit
