#include "idl/overlay/reader.h"

#include <gtest/gtest.h>

#include "tests/overlay/sample_map.h"

namespace tacit {
namespace {

template <class Content>
Content only(const std::string& line) {
  const OverlayReading reading = read_overlay(line);
  EXPECT_TRUE(reading.findings.empty()) << to_text(reading.findings.front(), "m");
  return std::get<Content>(reading.map.statements.at(0).content);
}

TEST(OverlayReader, TakesASampleWithoutAnyFinding) { EXPECT_EQ(findings_of(kSampleMap), ""); }

TEST(OverlayReader, TakesSignsPointsExponentsAndCommas) {
  const auto wall = only<MapShape>("WALL w -1, +2. .5 1e1");
  EXPECT_EQ(wall.points, (std::vector<MapPoint>{{-1.0, 2.0}, {0.5, 10.0}}));
}

TEST(OverlayReader, TakesKeywordsInAnyCase) {
  EXPECT_EQ(only<MapShape>("wAlL w 0 0 1 1").kind, ShapeKind::Wall);
}

TEST(OverlayReader, TakesTheLastOfAnOddNumberOfNumbersForASize) {
  EXPECT_EQ(only<MapShape>("GAP g 1 2 3 4 1.5").size_m, 1.5);
  EXPECT_EQ(only<MapShape>("GAP g 1 2 3 4").size_m, std::nullopt);
}

TEST(OverlayReader, TakesALineThatBeginsWithANumberForAContinuation) {
  EXPECT_EQ(only<MapShape>("WALL w 0 0\n1 1\n 2 2").points.size(), 3U);
}

TEST(OverlayReader, TakesAQuotedNameWithBlanksAndDashes) {
  EXPECT_EQ(only<MapShape>("PP \"a -- b\" 1 2").name, "a -- b");
}

TEST(OverlayReader, TakesAnObjectWithItsMobilityAndColour) {
  EXPECT_EQ(only<MapObject>("Object 1 2 3 Container \"purple\""),
            (MapObject{{1.0, 2.0}, 3.0, Mobility::Container, "purple"}));
}

TEST(OverlayReader, TakesTheLineControlMeasuresAndNoOtherLikeIt) {
  (void)only<MapMeasures>("Control Measures:");
  (void)only<MapMeasures>("CONTROL MEASURES");
  EXPECT_TRUE(std::holds_alternative<MapUnknown>(
      map_of("CONTROL MEASURES: PP a 1 2\n").statements.at(0).content));
}

TEST(OverlayReader, KeepsAnUnknownStatementWithAWarningAndAGuess) {
  EXPECT_EQ(findings_of("WAL w 0 0 1 1\n"),
            "m:1:1: warning: found \"WAL\", wanted a statement of a map; it is kept, not used, did "
            "you mean WALL?\n");
  EXPECT_EQ(std::get<MapUnknown>(map_of("FOO 1 -- c\n").statements.at(0).content).text, "FOO 1");
}

struct BadLine {
  const char* text;
  const char* wanted;
};

class BadStatement : public testing::TestWithParam<BadLine> {};

TEST_P(BadStatement, IsAnErrorWithItsPlace) {
  EXPECT_EQ(findings_of(GetParam().text).find(GetParam().wanted), 0U)
      << findings_of(GetParam().text);
}

INSTANTIATE_TEST_SUITE_P(
    Each, BadStatement,
    testing::Values(
        BadLine{"OBJECT 1 2 3 Fluid red", "m:1:14: error: found \"Fluid\", wanted FIXED, MOVABLE"},
        BadLine{"OBSTACLE 1 2",
                "m:1:13: error: found the end of OBSTACLE, wanted a number (radius)"},
        BadLine{"WALL w 1 2 x 3", "m:1:12: error: found \"x\", wanted a number"},
        BadLine{"WALL w 1 2", "m:1:11: error: found the end of WALL, wanted at least 2 points"},
        BadLine{"ROOM r 1 2 3 4", "m:1:15: error: found the end of ROOM, wanted at least 3 points"},
        BadLine{"GAP g 1 2 3 4 5 6", "m:1:18: error: found the end of GAP, wanted 2 points"},
        BadLine{"\nPP \"open 1 2", "m:2:4: error: found the end of the line in a text"},
        BadLine{"HEADING", "m:1:8: error: found the end of HEADING, wanted a number"},
        BadLine{"MISSION-AREA 1 2 3", "m:1:18: error: found 3, wanted the end of the line"},
        BadLine{"HALLWAY h CENTERLINE 1 2 3 4 EXTENTS 0 0",
                "m:1:30: error: found \"EXTENTS\", wanted "
                "WIDTH"},
        BadLine{"WALL w 1e999 0 1 1", "m:1:8: error: found \"1e999\", wanted a number"}));

TEST(OverlayReader, TellsEveryErrorOfAFile) {
  const OverlayReading reading = read_overlay("OBSTACLE 1\nPP a 1 2\nOBSTACLE 2\n");
  ASSERT_EQ(reading.findings.size(), 2U);
  EXPECT_EQ(reading.findings[1].at, (MapSpot{3, 11}));
  EXPECT_EQ(reading.map.statements.size(), 3U);
}

TEST(OverlayReader, RefusesAByteZeroWithItsPlace) {
  const OverlayReading reading = read_overlay(std::string_view("PP a 1 2\nP\0P", 12));
  ASSERT_FALSE(reading.findings.empty());
  EXPECT_EQ(reading.findings[0].at, (MapSpot{2, 2}));
  EXPECT_EQ(reading.findings[0].severity, Severity::Error);
}

}  // namespace
}  // namespace tacit
