#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/process/programs.h"

namespace tacit {
namespace {

using nlohmann::json;

struct Operation {
  const char* name;
  std::vector<std::string> words;
};

json result(const Operation& operation, const Scratch& scratch, bool one_process) {
  std::vector<std::string> words{"run"};
  words.insert(words.end(), operation.words.begin(), operation.words.end());
  for (const char* word : {"--seed", "7", "--json", "--quiet", "--out"}) words.emplace_back(word);
  words.push_back(scratch / (one_process ? "one" : "dds"));
  if (one_process) words.emplace_back("--one-process");
  const Finished finished = tacit(words);
  EXPECT_EQ(finished.exit_code, 0) << finished.err;
  return json::parse(finished.out, nullptr, false);
}

std::string name_of(const testing::TestParamInfo<Operation>& param) { return param.param.name; }

class OperationRun : public testing::TestWithParam<Operation> {};

TEST_P(OperationRun, HasTheSameEventLogOverDdsAndInOneProcessAndAFullChecklist) {
  const Scratch scratch;
  const json dds = result(GetParam(), scratch, false);
  const json one = result(GetParam(), scratch, true);
  ASSERT_TRUE(dds.is_object() && one.is_object());
  EXPECT_EQ(dds["event_log_sha256"], one["event_log_sha256"]);
  EXPECT_TRUE(dds["complete"] == true && dds["repeatable"] == true);
  EXPECT_EQ(dds["checklist"]["done"], dds["checklist"]["wanted"]) << dds["checklist"].dump(2);
  EXPECT_EQ(dds["checklist"], one["checklist"]);
}

INSTANTIATE_TEST_SUITE_P(Operations, OperationRun,
                         testing::Values(Operation{"OneRobot",
                                                   {"biohazard.cdl", "--map", "office.ovl"}},
                                         Operation{"TwoRobotsAndASentry",
                                                   {"biohazard_pair.cdl", "--map", "office.ovl",
                                                    "--extra", "sentry.cdl"}}),
                         name_of);

TEST(OperationRun, TellsWhatIsWrongWithItsFiles) {
  const auto error = [](std::vector<std::string> words) {
    words.insert(words.begin(), "run");
    const Finished finished = tacit(words);
    EXPECT_EQ(finished.exit_code, 2);
    return finished.err;
  };
  EXPECT_NE(error({"biohazard.cdl"}).find("wanted --map FILE.ovl"), std::string::npos);
  EXPECT_NE(error({"nothing.cdl", "--map", "office.ovl"}).find("there is no file nothing.cdl"),
            std::string::npos);
  EXPECT_NE(error({"biohazrd.cdl", "--map", "office.ovl"}).find("did you mean"), std::string::npos);
  EXPECT_NE(error({"sentry.cdl", "--map", "waypoints.ovl"}).find("no point of the map is called"),
            std::string::npos);
  EXPECT_NE(error({"biohazard.cdl", "--map", "office.ovl", "--start", "1"}).find("wanted x,y"),
            std::string::npos);
  EXPECT_NE(error({"guard", "--extra", "sentry.cdl"}).find("go with a mission file"),
            std::string::npos);
}

}  // namespace
}  // namespace tacit
