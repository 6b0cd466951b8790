#pragma once

#include <string>

#include "idl/overlay/check.h"
#include "idl/overlay/reader.h"

namespace tacit {

inline const std::string kSampleMap =
    "-- Two rooms on a hallway\n"
    "mission-area 20 12.5e0\n"
    "SITE \"a hut\"\n\n"
    "Control Measures:\n"
    "PP StartPlace* 2., 1 +0.5 -- here they begin\n"
    "ROOM \"east\" 10 4 20 4 20 12 10 12\n"
    "DOOR d1* 14 4 15 4\n"
    "HALLWAY h* CENTERLINE 0 2 20 2 WIDTH 4 EXTENTS 0 0 20 0 20 4 0 4\n"
    "WALL \"\" 0 4 20 4\n"
    "   10 12\n"
    "Obstacle 5 8 0.5\n"
    "OBJECT 6 6 0.3 Movable orange\n";

inline OverlayMap map_of(const std::string& text) { return read_overlay(text).map; }

/// All findings, a line each.
inline std::string findings_of(const std::string& text) {
  const OverlayReading reading = read_overlay(text);
  std::string lines;
  for (const MapFinding& finding : reading.findings) lines += to_text(finding, "m") + '\n';
  for (const MapFinding& finding : check(reading.map)) lines += to_text(finding, "m") + '\n';
  return lines;
}

}  // namespace tacit
