#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "tests/process/programs.h"

namespace tacit {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

struct Combination {
  std::string environment;
  std::string learner;
  int robots = 1;
  int seed = 1;
};

/// Every learner, environment and team size, in a new company each time. Dangers are many, so that
/// much happens in a short time.
std::vector<Combination> combinations() {
  const std::vector<std::string> learners{"q", "homogeneous", "q", "heterogeneous"};
  const std::vector<int> teams{6, 2, 3, 12, 1};
  std::vector<Combination> all;
  for (int i = 0; i < 14; ++i) {
    const auto n = static_cast<std::size_t>(i);
    const std::string environment(1, static_cast<char>('a' + i % 7));
    all.push_back({"forage_" + environment, learners[n % 4], teams[n % 5], 300 + 11 * i});
  }
  return all;
}

std::string name_of(const testing::TestParamInfo<Combination>& info) {
  const Combination& it = info.param;
  return it.environment + it.learner + "Robots" + std::to_string(it.robots) + "Seed" +
         std::to_string(it.seed);
}

std::vector<std::string> words(const Combination& it) {
  return {"run",       it.environment,
          "--learner", it.learner,
          "--robots",  std::to_string(it.robots),
          "--seed",    std::to_string(it.seed),
          "--set",     "mud.per_tick=0.001",
          "--set",     "hunters.min_wait_ticks=50",
          "--set",     "hunters.max_wait_ticks=150",
          "--set",     "end.cap_ticks=1200",
          "--json",    "--quiet"};
}

json result(std::vector<std::string> words, const std::vector<std::string>& more) {
  words.insert(words.end(), more.begin(), more.end());
  const Finished finished = tacit(words);
  EXPECT_EQ(finished.exit_code, 0) << finished.err;
  return json::parse(finished.out, nullptr, false);
}

std::vector<std::string> policies(const fs::path& folder, int robots) {
  std::vector<std::string> texts;
  for (int robot = 1; robot <= robots; ++robot) {
    texts.push_back(text_of(folder / ("robot_" + std::to_string(robot) + ".json")));
  }
  return texts;
}

class SameForageRun : public testing::TestWithParam<Combination> {};

TEST_P(SameForageRun, HasTheSameEventLogAndTeachesTheSameOverDdsAndInOneProcess) {
  const Scratch scratch;
  const json dds = result(words(GetParam()), {"--out", scratch / "dds"});
  const json one = result(words(GetParam()), {"--out", scratch / "one", "--one-process"});
  ASSERT_TRUE(dds.is_object() && one.is_object());
  EXPECT_EQ(dds["event_log_sha256"], one["event_log_sha256"]);
  EXPECT_EQ(dds["metrics"], one["metrics"]);
  EXPECT_TRUE(dds["complete"] == true && dds["repeatable"] == true);
  EXPECT_TRUE(one["metrics"]["score_ticks"].is_number());
  const bool learns = GetParam().learner == "q";
  EXPECT_EQ(fs::exists(scratch / "one/learned"), learns);
  if (learns) {
    EXPECT_EQ(policies(scratch / "dds/learned", GetParam().robots),
              policies(scratch / "one/learned", GetParam().robots));
  }
}

INSTANTIATE_TEST_SUITE_P(Grid, SameForageRun, testing::ValuesIn(combinations()), name_of);

TEST(ForageRun, BeginsWithWhatAnEarlierRunTaughtOverDdsAsInOneProcess) {
  const Scratch scratch;
  const Combination it{"forage_b", "q", 3, 5};
  (void)result(words(it), {"--out", scratch / "first", "--one-process"});
  for (const char* copy : {"policies-dds", "policies-one"}) {
    fs::copy(scratch / "first/learned", scratch / copy, fs::copy_options::recursive);
  }
  const json fresh = result(words(it), {"--out", scratch / "fresh", "--one-process"});
  const json dds =
      result(words(it), {"--out", scratch / "dds", "--policy", scratch / "policies-dds"});
  const json one = result(
      words(it), {"--out", scratch / "one", "--policy", scratch / "policies-one", "--one-process"});
  EXPECT_EQ(dds["event_log_sha256"], one["event_log_sha256"]);
  EXPECT_NE(one["event_log_sha256"], fresh["event_log_sha256"]);
  EXPECT_EQ(policies(scratch / "policies-dds", 3), policies(scratch / "policies-one", 3));
  EXPECT_NE(policies(scratch / "policies-one", 3), policies(scratch / "first/learned", 3));
}

TEST(ForageRun, ThatBeganWithPoliciesIsVerifiedWithThem) {
  const Scratch scratch;
  const Combination it{"forage_b", "q", 3, 5};
  (void)result(words(it),
               {"--out", scratch / "first", "--policy", scratch / "policies", "--one-process"});
  (void)result(words(it),
               {"--out", scratch / "second", "--policy", scratch / "policies", "--one-process"});
  EXPECT_EQ(tacit({"verify", scratch / "second"}).exit_code, 0);
  fs::remove_all(scratch / "second/inherited");
  EXPECT_EQ(tacit({"verify", scratch / "second"}).exit_code, 5);
}

TEST(ForageRun, LeavesPoliciesThatDoNotFitAlone) {
  const Scratch scratch;
  const Combination it{"forage_b", "q", 2, 5};
  (void)result(words(it),
               {"--out", scratch / "first", "--policy", scratch / "policies", "--one-process"});
  const std::string cut = text_of(scratch / "policies/robot_2.json").substr(0, 500);
  std::ofstream(scratch / "policies/robot_2.json", std::ios::trunc) << cut;
  const auto before = policies(scratch / "policies", 2);
  for (const char* transport : {"--one-process", "--quiet"}) {
    std::vector<std::string> again = words(it);
    again.insert(again.end(),
                 {"--out", scratch / "second", "--policy", scratch / "policies", transport});
    const Finished finished = tacit(again);
    EXPECT_EQ(finished.exit_code, 2);
    EXPECT_NE(finished.err.find("robot_2.json"), std::string::npos) << finished.err;
    EXPECT_FALSE(fs::exists(scratch / "second"));
  }
  EXPECT_EQ(policies(scratch / "policies", 2), before);
}

TEST(ForageRun, RefusesThePoliciesOfAnotherTeam) {
  const Scratch scratch;
  (void)result(words({"forage_b", "q", 2, 5}),
               {"--out", scratch / "first", "--policy", scratch / "policies", "--one-process"});
  std::vector<std::string> other = words({"forage_b", "q", 3, 5});
  other.insert(other.end(), {"--out", scratch / "second", "--policy", scratch / "policies"});
  const Finished finished = tacit(other);
  EXPECT_EQ(finished.exit_code, 2);
  EXPECT_NE(finished.err.find("wanted those of robots 1 to 3"), std::string::npos) << finished.err;
}

TEST(ForageRun, TellsWhereItsTimeWent) {
  const Scratch scratch;
  const Finished finished =
      tacit({"run", "forage_a", "--one-process", "--profile", "--quiet", "--out", scratch / "run"});
  EXPECT_EQ(finished.exit_code, 0);
  for (const char* part : {"brains decide", "world: motion (Bullet)", "world: sensing"}) {
    EXPECT_NE(finished.err.find(part), std::string::npos) << finished.err;
  }
}

TEST(ForageRun, EndsWhenTheLastMineIsStored) {
  const Scratch scratch;
  const json run = result({"run", "forage_a", "--learner", "homogeneous", "--robots", "6", "--set",
                           "hunters.count=0", "--set", "mud.per_tick=0", "--json", "--quiet"},
                          {"--out", scratch / "run", "--one-process"});
  EXPECT_EQ(run["metrics"]["mines_stored"], run["metrics"]["mines"]);
  EXPECT_EQ(run["metrics"]["failed"], 0);
  EXPECT_EQ(run["ticks"], run["metrics"]["score_ticks"]);
}

TEST(ForageRun, OfALostTeamScoresTheCapAndEndsEarly) {
  const Scratch scratch;
  const json run = result({"run", "forage_a", "--learner", "homogeneous", "--robots", "1", "--set",
                           "mud.per_tick=0.1", "--json", "--quiet"},
                          {"--out", scratch / "run", "--one-process"});
  EXPECT_EQ(run["metrics"]["score_ticks"], 1000000);
  EXPECT_EQ(run["metrics"]["failed"], 1);
  EXPECT_LT(run["ticks"], 1000);
}

}  // namespace
}  // namespace tacit
