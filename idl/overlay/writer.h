#pragma once

#include <string>

#include "idl/overlay/overlay.h"

namespace tacit {

/// The map as a file. A statement that means what its file spelled is printed as it was spelled, so
/// an unchanged map prints back byte for byte; others are printed anew.
[[nodiscard]] std::string to_text(const OverlayMap& map);

/// Every statement anew, one a line: keywords in capitals, names in quotes, numbers in the shortest
/// form that reads back to the same bits. Comments and empty lines stay.
[[nodiscard]] std::string to_canonical_text(const OverlayMap& map);

/// One statement anew, without the end of the line. Quotes and ends of lines in names, which the
/// format cannot hold, become blanks.
[[nodiscard]] std::string to_text(const MapContent& content);

}  // namespace tacit
