#include <gtest/gtest.h>

#include <csignal>
#include <nlohmann/json.hpp>

#include "tests/process/programs.h"

namespace tacit {
namespace {

using nlohmann::json;

const std::vector<std::string> kNoise{"--set", "sight.bearing_noise_deg=20", "--set",
                                      "sight.range_noise_m=0.5"};

std::vector<std::string> preview_words(const std::vector<std::string>& more) {
  std::vector<std::string> words{"preview", "biohazard.cdl", "--map", "office.ovl"};
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

Finished preview(std::vector<std::string> more) {
  more.insert(more.end(), kNoise.begin(), kNoise.end());
  return tacit(preview_words(more));
}

TEST(PreviewCommand, TellsTheSameWhateverTheNumberOfJobs) {
  const Finished one = preview({"--flights", "6", "--seed", "5", "--jobs", "1", "--json"});
  const Finished two = preview({"--flights", "6", "--seed", "5", "--jobs", "2", "--json"});
  EXPECT_EQ(one.exit_code, 0) << one.err;
  EXPECT_EQ(one.out, two.out);
  const json told = json::parse(one.out, nullptr, false);
  EXPECT_EQ(told["wanted"], 6);
  EXPECT_EQ(told["flown"], 6);
  EXPECT_EQ(told["cut_short"], false);
  EXPECT_EQ(told["flights"][5]["seed"], 10);
  EXPECT_GE(told["success"]["high"], told["success"]["value"]);
}

TEST(PreviewCommand, TellsPeopleWithProgressBeside) {
  const Finished told = preview({"--flights", "3"});
  EXPECT_NE(told.out.find("biohazard.cdl on office.ovl"), std::string::npos) << told.out;
  EXPECT_NE(told.out.find("3 of 3 flights, seeds from 1 on"), std::string::npos) << told.out;
  EXPECT_NE(told.err.find("3 of 3 flights (100 %)"), std::string::npos) << told.err;
  EXPECT_EQ(preview({"--flights", "3", "--quiet"}).err, "");
}

TEST(PreviewCommand, SaysWhenNothingDrawsChance) {
  const Finished told = tacit(preview_words({"--flights", "2"}));
  EXPECT_NE(told.out.find("All flights went the same way"), std::string::npos) << told.out;
}

TEST(PreviewCommand, TellsWhatWasFlownWhenItIsInterrupted) {
  std::vector<std::string> words = preview_words({"--flights", "100000", "--jobs", "1", "--json"});
  words.insert(words.end(), kNoise.begin(), kNoise.end());
  Running running(tacit_words(words));
  ASSERT_TRUE(becomes_true([&] { return !running.said().empty(); }));
  running.send(SIGINT);
  const Finished finished = running.finish(std::chrono::seconds(30));
  EXPECT_EQ(finished.exit_code, 130) << finished.err;
  const json told = json::parse(finished.out, nullptr, false);
  EXPECT_EQ(told["cut_short"], true);
  EXPECT_LT(told["flown"], 100000);
  EXPECT_EQ(told["flights"].size(), told["flown"]);
}

/// What is said when it is refused as bad input.
std::string refusal(const std::vector<std::string>& words) {
  const Finished finished = tacit(words);
  return finished.exit_code == 2 && finished.out.empty() ? finished.err : "(not refused)";
}

TEST(PreviewCommand, RefusesWhatCannotBeFlown) {
  EXPECT_NE(refusal({"preview", "guard"}).find("found guard, wanted a mission (.cdl)"),
            std::string::npos);
  EXPECT_NE(refusal({"preview", "biohazard.cdl"}).find("wanted --map"), std::string::npos);
  EXPECT_NE(refusal({"preview", "nothing.cdl", "--map", "office.ovl"}).find("there is no file"),
            std::string::npos);
  EXPECT_NE(refusal(preview_words({"--seed", "x"})).find("--seed"), std::string::npos);
  EXPECT_EQ(tacit(preview_words({"--flights", "0"})).exit_code, 2);
  EXPECT_EQ(tacit(preview_words({"--jobs", "0"})).exit_code, 2);
}

}  // namespace
}  // namespace tacit
