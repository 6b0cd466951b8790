#pragma once

#include <string>

#include "console/record/run_directory.h"

namespace tacit {

/// What does not move on a map, as JSON for those who draw it: one object with `name`, `width_m`,
/// `height_m`, `shift` (world = map + shift), `walls` (rows of x1, y1, x2, y2), `discs` (x, y, r),
/// `rooms`, `doors`, `halls`, `points`, `start`, `target` and `base`; all in the world's frame.
/// Throws ConfigError when the map has errors, naming them.
[[nodiscard]] std::string scene_of_map(const std::string& overlay, const std::string& name);

/// The same for a recorded run, its obstacles by chance included. Throws ConfigError when its
/// scenario makes no sense.
[[nodiscard]] std::string scene_of_run(const RunDirectory& directory);

}  // namespace tacit
