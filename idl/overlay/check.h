#pragma once

#include "idl/overlay/finding.h"
#include "idl/overlay/overlay.h"

namespace tacit {

/// What does not fit together in a map that could be read, in order of place, the worst first when
/// there are more than `kMostFindings`.
///
/// Errors: an area or a hallway's width or a radius that is not positive, a room or hallway whose
/// outline encloses nothing. Warnings: things outside the area, a second start place or area, a
/// door that lies in no wall, a wall that lies whole in a door or gap, a room without a door or
/// gap, a wall or door without length, a name given twice to the same kind of thing, a measure
/// before CONTROL MEASURES.
[[nodiscard]] MapFindings check(const OverlayMap& map);

}  // namespace tacit
