#include "idl/overlay/change_script.h"

#include <gtest/gtest.h>

namespace tacit {
namespace {

const std::string kScript =
    "STEP_COUNT 1 100\n"
    "add obstacle 3 4 0.5\n"
    "region 0 0 20 20 add obstacle 3 1 5 7,2\n"
    "STEP_COUNT 50\n"
    "remove obstacle 3 4 0.5\n"
    "region 0 0 20 20 remove obstacle\n";

TEST(ChangeScript, IsReadStepByStep) {
  const ChangeReading reading = read_changes(kScript);
  EXPECT_TRUE(reading.findings.empty());
  ASSERT_EQ(reading.script.size(), 2U);
  EXPECT_EQ(reading.script[0].period, 100);
  const auto region = std::get<RegionAdd>(reading.script[0].changes.at(1));
  EXPECT_EQ(region.cover_percent, 3.0);
  EXPECT_EQ(region.seed, 7);
  EXPECT_EQ(region.increment, 2);
}

TEST(ChangeScript, PrintsWhatReadsBackToAnEqualScript) {
  const ChangeScript script = read_changes(kScript).script;
  EXPECT_EQ(to_text(script), kScript);
  EXPECT_EQ(read_changes(to_text(script)).script, script);
}

struct BadLine {
  const char* text;
  const char* finding;
};

class BadChange : public testing::TestWithParam<BadLine> {};

TEST_P(BadChange, IsAnErrorWithItsPlace) {
  const ChangeReading reading = read_changes(GetParam().text);
  ASSERT_EQ(reading.findings.size(), 1U);
  EXPECT_EQ(to_text(reading.findings[0], "s"), GetParam().finding);
}

INSTANTIATE_TEST_SUITE_P(
    Each, BadChange,
    testing::Values(
        BadLine{"add obstacle 1 2 3",
                "s:1:1: error: found \"add\", wanted STEP_COUNT before the first change"},
        BadLine{"STEP_COUNT 1\nadd obstacle 1 2 0",
                "s:2:18: error: found 0, wanted a radius above 0"},
        BadLine{"STEP_COUNT 1\nregion 0 0 1 1 grow obstacle",
                "s:2:16: error: found \"grow\", wanted ADD or REMOVE"},
        BadLine{"STEP_COUNT 1.5",
                "s:1:12: error: found 1.5, wanted a step, a whole number of at least 0"},
        BadLine{"DANCE",
                "s:1:1: error: found \"DANCE\", wanted STEP_COUNT, ADD, REMOVE or REGION"}));

}  // namespace
}  // namespace tacit
