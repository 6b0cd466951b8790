#pragma once

#include <cstddef>
#include <string_view>

#include "idl/overlay/finding.h"
#include "idl/overlay/overlay.h"

namespace tacit {

/// A map and what was wrong with its text.
struct OverlayReading {
  OverlayMap map;
  MapFindings findings;  ///< In order of place.
};

/// More errors and warnings than this are not told, at most half of them of either kind.
inline constexpr std::size_t kMostFindings = 100;
/// A statement has at most so many words.
inline constexpr std::size_t kMostWords = 200'000;
/// A map has at most so many statements; more are an error and stay unread in the map's `ending`.
inline constexpr std::size_t kMostStatements = 2'000'000;

/// Reads a MissionLab overlay (.ovl).
///
/// A statement begins with a word at the beginning of a line; a line that begins with a number, or
/// with CENTERLINE, WIDTH or EXTENTS, goes on with the statement before. A statement with an error,
/// or one that nobody knows, is kept as MapUnknown, so that the map prints back as it was. Bytes
/// that are no UTF-8 are kept as they are; a byte 0 is an error.
[[nodiscard]] OverlayReading read_overlay(std::string_view text);

}  // namespace tacit
