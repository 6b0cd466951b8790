#pragma once

#include "deploy/lockstep/compose_operation.h"
#include "deploy/lockstep/setup.h"

namespace tacit {

/// Simulated time after which an operation that has not ended is out of time, unless it is told
/// otherwise: an hour.
inline constexpr double kOperation_s = 3600.0;

/// The whole scenario of such an operation, all else as it is by default. Throws ConfigError as
/// `compose_operation` does.
[[nodiscard]] Setup operation_setup(const OperationWish& wish);

}  // namespace tacit
