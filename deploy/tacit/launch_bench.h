#pragma once

#include "deploy/tacit/exit_codes.h"

namespace tacit {

/// Prints, for teams of 6, 12, 25 and 50, the memory of an agent process and the time from launch
/// to the first tick. Memory is the proportional set size, in which a page that n processes share
/// counts a n-th for each.
[[nodiscard]] Exit bench_launches();

}  // namespace tacit
