// Maps large enough that work which grows faster than the text would not end in the test's time.

#include <gtest/gtest.h>

#include "idl/overlay/change_script.h"
#include "idl/overlay/writer.h"
#include "tests/overlay/sample_map.h"

namespace tacit {
namespace {

std::string repeated(const std::string& piece, std::size_t size) {
  std::string text;
  text.reserve(size + piece.size());
  while (text.size() < size) text += piece;
  return text;
}

class LargeMap : public testing::TestWithParam<const char*> {};

TEST_P(LargeMap, IsReadInTimeThatGrowsWithItsSizeAndPrintsBack) {
  const std::string text = repeated(GetParam(), 500'000);
  const OverlayReading reading = read_overlay(text);
  EXPECT_LE(reading.findings.size(), kMostFindings);
  EXPECT_TRUE(to_text(reading.map) == text);
  (void)read_changes(text);
}

INSTANTIATE_TEST_SUITE_P(Pieces, LargeMap,
                         testing::Values("WALL \"w\" 0 0 1 1 -- c\n", "\"", "\"\n", "-", "1 ", "a",
                                         "a\n", "WALL w 1 2\n3 4\n", "\n", "\r", "WALL", "0\n",
                                         "\" \" ", "9", "\xff", "PP a 1 2\nCENTERLINE "));

TEST(LargeMap, OfFiftyMegabytesIsReadWhole) {
  const std::string text = repeated("OBSTACLE 1.25 2.5 0.75 -- a rock in the way\n", 50'000'000);
  const OverlayReading reading = read_overlay(text);
  EXPECT_TRUE(reading.findings.empty());
  EXPECT_GT(reading.map.statements.size(), 1'000'000U);
}

TEST(LargeMap, OfTooManyStatementsIsAnErrorAndKeepsTheRest) {
  const std::string text = repeated("a\n", 2 * kMostStatements + 100);
  const OverlayReading reading = read_overlay(text);
  EXPECT_EQ(reading.map.statements.size(), kMostStatements);
  EXPECT_TRUE(has_errors(reading.findings));
  EXPECT_EQ(reading.findings.back().at.line, kMostStatements + 1);
  EXPECT_TRUE(to_text(reading.map) == text);
}

}  // namespace
}  // namespace tacit
