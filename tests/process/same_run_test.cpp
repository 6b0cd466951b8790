#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/process/programs.h"

namespace tacit {
namespace {

using nlohmann::json;

/// A short run: what varies between the tests below.
struct Combination {
  std::string learner;
  int strategy = 1;
  int robots = 1;
  int seed = 1;
  std::vector<std::string> more;
};

/// Every learner, strategy and team size, in a new company each time.
std::vector<Combination> combinations() {
  const std::vector<std::string> learners{"static1", "static2", "lm"};
  const std::vector<int> teams{1, 2, 3, 6, 4, 8, 5, 12};
  std::vector<Combination> all;
  for (int i = 0; i < 24; ++i) {
    const auto n = static_cast<std::size_t>(i);
    all.push_back({learners[n % 3], 1 + i % 5, teams[n % 8], 100 + 7 * i, {}});
  }
  all[0].more = {"--set", "sight.range_noise_m=0.2", "--set", "sight.bearing_noise_deg=1"};
  all[1].more = {"--set", "obstacles.coverage_percent=12"};
  all[2].more = {"--set", "physics.substeps=3"};
  return all;
}

std::string name_of(const testing::TestParamInfo<Combination>& info) {
  const Combination& it = info.param;
  return it.learner + "Strategy" + std::to_string(it.strategy) + "Robots" +
         std::to_string(it.robots) + "Seed" + std::to_string(it.seed);
}

json result(const Combination& it, const Scratch& scratch, bool one_process) {
  std::vector<std::string> words{"run",        "guard",
                                 "--learner",  it.learner,
                                 "--strategy", std::to_string(it.strategy),
                                 "--robots",   std::to_string(it.robots),
                                 "--seed",     std::to_string(it.seed),
                                 "--duration", "60",
                                 "--json",     "--quiet",
                                 "--out",      scratch / (one_process ? "one" : "dds")};
  words.insert(words.end(), it.more.begin(), it.more.end());
  if (one_process) {
    words.emplace_back("--one-process");
  }
  const Finished finished = tacit(words);
  EXPECT_EQ(finished.exit_code, 0) << finished.err;
  return json::parse(finished.out, nullptr, false);
}

class SameRun : public testing::TestWithParam<Combination> {};

TEST_P(SameRun, HasTheSameEventLogOverDdsAndInOneProcess) {
  const Scratch scratch;
  const json dds = result(GetParam(), scratch, false);
  const json one = result(GetParam(), scratch, true);
  ASSERT_TRUE(dds.is_object() && one.is_object());
  EXPECT_EQ(dds["event_log_sha256"], one["event_log_sha256"]);
  EXPECT_EQ(dds["metrics"], one["metrics"]);
  EXPECT_EQ(dds["ticks"], 600);
  EXPECT_TRUE(dds["complete"] == true && dds["repeatable"] == true);
}

INSTANTIATE_TEST_SUITE_P(Combinations, SameRun, testing::ValuesIn(combinations()), name_of);

TEST(SameRun, HasTheSameTrajectoriesOverDdsAndInOneProcess) {
  const Scratch scratch;
  const Combination it{"lm", 3, 3, 5, {"--trajectories"}};
  (void)result(it, scratch, false);
  (void)result(it, scratch, true);
  const std::string dds = text_of(scratch / "dds/trajectories.csv");
  EXPECT_GT(dds.size(), 600U * 3U);
  EXPECT_EQ(dds, text_of(scratch / "one/trajectories.csv"));
}

TEST(SameRun, HasAnotherEventLogWithAnotherSeed) {
  const Scratch scratch;
  const json a = result({"lm", 1, 2, 1, {}}, scratch, true);
  const Scratch other;
  const json b = result({"lm", 1, 2, 2, {}}, other, true);
  EXPECT_NE(a["event_log_sha256"], b["event_log_sha256"]);
}

}  // namespace
}  // namespace tacit
