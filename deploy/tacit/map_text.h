#pragma once

#include <string>

#include "idl/overlay/overlay.h"

namespace tacit {

/// The map in letters, at most `columns` wide, north on top, a letter twice as high as wide, with a
/// line that tells what the letters mean. Throws ConfigError as `walls_of` does.
[[nodiscard]] std::string text_picture_of(const OverlayMap& map, int columns);

}  // namespace tacit
