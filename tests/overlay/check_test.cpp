#include "idl/overlay/check.h"

#include <gtest/gtest.h>

#include "tests/overlay/sample_map.h"

namespace tacit {
namespace {

std::string found(const std::string& line) {
  return findings_of("MISSION-AREA 20 20\nCONTROL MEASURES:\n" + line + '\n');
}

struct Oddity {
  const char* line;
  const char* finding;
};

class OddMap : public testing::TestWithParam<Oddity> {};

TEST_P(OddMap, IsFoundWithItsPlace) {
  EXPECT_EQ(found(GetParam().line).find(GetParam().finding), 0U) << found(GetParam().line);
}

INSTANTIATE_TEST_SUITE_P(
    Each, OddMap,
    testing::Values(
        Oddity{"OBSTACLE 30 2 1", "m:3:1: warning: found an OBSTACLE reaching outside"},
        Oddity{"OBJECT 3 -2 1 Fixed red", "m:3:1: warning: found an OBJECT reaching outside"},
        Oddity{"OBSTACLE 3 2 0", "m:3:1: error: found an OBSTACLE of radius 0, wanted it above 0"},
        Oddity{"OBJECT 3 2 -1 Fixed red", "m:3:1: error: found an OBJECT of radius -1"},
        Oddity{"PP StartPlace 1 1\nSP s 2 2", "m:4:1: warning: found a second start place"},
        Oddity{"WALL w 1 1 1 1", "m:3:1: warning: found WALL \"w\" without length"},
        Oddity{"ROOM r 1 1 2 2 3 3\nGAP g 1 2 2 1", "m:3:1: error: found ROOM \"r\" whose outline"},
        Oddity{"ROOM r 1 1 2 1 2 2", "m:3:1: warning: found ROOM \"r\" without a door"},
        Oddity{"ROOM r 1 1 5 1 5 5 1 5\nGAP g 3 0 3 2\nDOOR d 7 7 8 8",
               "m:5:1: warning: found DOOR \"d\" in no wall"},
        Oddity{"WALL w 1 5 5 5\nDOOR d 7 7 8 8", "m:4:1: warning: found DOOR \"d\" in no wall"},
        Oddity{"DOOR d 7 7 8 8", "m:3:1: warning: found DOOR \"d\" in no wall"},
        Oddity{"WALL w 4 5 6 5\nGAP g 5 4 5 6 2",
               "m:3:1: warning: found WALL \"w\" whole in GAP \"g\", which opens it"},
        Oddity{"PP a 1 1\nPP a 2 2", "m:4:1: warning: found PP \"a\" again, wanted another name"},
        Oddity{"MISSION-AREA 2 2", "m:3:1: warning: found a second MISSION-AREA"},
        Oddity{"HALLWAY h CENTERLINE 1 1 2 1 WIDTH 0 EXTENTS 1 1 2 1 2 2",
               "m:3:1: error: found HALLWAY \"h\" of width 0"}));

TEST(OverlayCheck, LetsARoomBeShutOnAMapThatDrawsItsWalls) {
  EXPECT_EQ(found("ROOM r 1 1 2 1 2 2\nWALL w 1 1 2 1 2 2 1 1"), "");
}

TEST(OverlayCheck, RefusesAnAreaThatIsNone) {
  EXPECT_NE(findings_of("MISSION-AREA 0 5\n").find("m:1:1: error: found a MISSION-AREA of 0 by 5"),
            std::string::npos);
}

}  // namespace
}  // namespace tacit
