#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "idl/types/event.h"

namespace tacit {

/// A stretch of a run's event log, so that a reader sees what it misses.
struct EventBatch {
  static constexpr std::size_t kMaxEvents = 256;

  std::uint64_t first = 0;    ///< Index in the log of `events[0]`; the log starts at 0.
  std::vector<Event> events;  ///< At most `kMaxEvents`.
};

}  // namespace tacit
