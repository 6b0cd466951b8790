#include "idl/overlay/writer.h"

#include <gtest/gtest.h>

#include "idl/types/random.h"
#include "tests/overlay/sample_map.h"

namespace tacit {
namespace {

TEST(OverlayWriter, PrintsAnUnchangedMapByteForByte) {
  for (const std::string& text :
       {kSampleMap, std::string(), std::string("\r\n-- only this"), std::string("PP a 1 2"),
        std::string("OBSTACLE x\n\tFOO \"b\r\n")}) {
    EXPECT_EQ(to_text(map_of(text)), text);
  }
}

TEST(OverlayWriter, PrintsOnlyTheChangedLineAnew) {
  OverlayMap map = map_of("pp a 1 2 -- one\nwall b 0 0 1. 1 -- two\n");
  std::get<MapShape>(map.statements[1].content).points[1].x_m = 3.0;
  EXPECT_EQ(to_text(map), "pp a 1 2 -- one\nWALL \"b\" 0 0 3 1 -- two\n");
}

TEST(OverlayWriter, PrintsANewStatementOnALineOfItsOwn) {
  OverlayMap map = map_of("pp a 1 2");
  map.statements.push_back({MapObstacle{{1.0, 2.0}, 0.5, {}}, {}, {}, {}});
  EXPECT_EQ(to_text(map), "pp a 1 2\nOBSTACLE 1 2 0.5\n");
}

TEST(OverlayWriter, PrintsACanonicalTextThatIsItsOwnCanonicalText) {
  const std::string once = to_canonical_text(map_of(kSampleMap));
  EXPECT_EQ(to_canonical_text(map_of(once)), once);
  EXPECT_EQ(map_of(once), map_of(kSampleMap));
}

TEST(OverlayWriter, KeepsTheNameOfAnObstacle) {
  EXPECT_EQ(to_canonical_text(map_of("obstacle rock 1 2 0.50\n")), "OBSTACLE \"rock\" 1 2 0.5\n");
}

TEST(OverlayWriter, KeepsBytesThatMakeATextWrong) {
  const std::string_view text("obstacle a\0b 1 2 0.5\n", 22);
  const OverlayReading again = read_overlay(to_canonical_text(read_overlay(text).map));
  EXPECT_TRUE(has_errors(again.findings));
}

TEST(OverlayWriter, KeepsCommentsBetweenTheLinesOfAStatement) {
  const std::string text = "wall a 0 0 -- from here\n  1 1 -- to there\npp \"b -- c\" 1 2\n";
  EXPECT_EQ(to_canonical_text(map_of(text)),
            "wall a 0 0 -- from here\n  1 1 -- to there\nPP \"b -- c\" 1 2\n");
}

double number(Stream& chance) { return chance.uniform(-1.0, 1.0) * 1e3; }

MapContent content(Stream& chance) {
  std::vector<MapPoint> points;
  for (std::uint64_t n = 3 + chance.below(4); n > 0; --n) {
    points.push_back({number(chance), number(chance)});
  }
  switch (chance.below(5)) {
    case 0:
      return MapObstacle{points[0], number(chance),
                         chance.below(2) ? std::optional(2.5) : std::nullopt,
                         chance.below(2) ? "rock 7" : ""};
    case 1:
      return MapObject{points[0], number(chance), Mobility::Movable, "red"};
    case 2:
      return MapHallway{"h", points, number(chance), points};
    case 3:
      return MapHeader{HeaderKind::Origin, {"UTM", "a b", "7"}, {number(chance)}};
    default:
      return MapShape{chance.below(2) ? ShapeKind::Wall : ShapeKind::Room, "a name*", points,
                      chance.below(2) ? std::optional(number(chance)) : std::nullopt};
  }
}

TEST(OverlayWriter, PrintsWhatReadsBackToAnEqualMap) {
  Stream chance(7, "maps");
  for (int round = 0; round < 200; ++round) {
    OverlayMap map;
    for (std::uint64_t n = chance.below(12); n > 0; --n) {
      map.statements.push_back({content(chance), {}, {}, {}});
    }
    ASSERT_EQ(map_of(to_text(map)), map) << to_text(map);
  }
}

}  // namespace
}  // namespace tacit
