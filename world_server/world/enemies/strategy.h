#pragma once

#include <cstdint>
#include <span>

#include "idl/types/event.h"

namespace tacit {

/// A recurring arrival of enemies from one side.
struct Wave {
  EnemyKind kind = EnemyKind::Normal;
  double from_deg = 0.0;       ///< Direction from the target to the spawn place; 0 east, 90 north.
  std::int64_t size = 1;       ///< Enemies at once.
  double period_s = 10.0;      ///< Between arrivals.
  std::int64_t keep = 0;       ///< When > 0: only make up for losses, so that `keep` are alive.
  bool any_direction = false;  ///< Random direction; the pair's other half comes from opposite.
};

/// The waves of attack strategy 1 to 5 (paper, section 2); none for strategy 0.
[[nodiscard]] std::span<const Wave> strategy_waves(std::int64_t strategy);

}  // namespace tacit
