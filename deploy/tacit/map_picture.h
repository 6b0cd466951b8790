#pragma once

#include <string>

#include "idl/overlay/overlay.h"

namespace tacit {

/// The map as a picture (SVG 1.1), about 1000 pixels on its longer side, north up: the area, rooms
/// and hallways, walls with their doors and gaps, obstacles, objects in their colours, points,
/// names that do not end in `*`, and a bar for the scale.
[[nodiscard]] std::string picture_of(const OverlayMap& map);

}  // namespace tacit
