#pragma once

#include "console/record/run_directory.h"

namespace tacit {

/// The simulated time per tick of a recorded run. Throws ConfigError when its scenario does not
/// say.
[[nodiscard]] double tick_s_of(const RunDirectory& directory);

}  // namespace tacit
