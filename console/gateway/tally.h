#pragma once

#include <array>
#include <atomic>
#include <cstdint>

#include "console/gateway/counters.h"

namespace tacit::gateway {

/// Counters that several threads add to.
struct Tally {
  using Count = std::atomic<std::uint64_t>;

  Count connections_open = 0;
  Count connections_total = 0;
  Count connections_refused = 0;
  Count websockets_open = 0;
  Count websockets_total = 0;
  Count websockets_stalled = 0;
  Count messages_sent = 0;
  Count messages_dropped = 0;
  Count messages_received = 0;
  Count bytes_sent = 0;
  Count bytes_received = 0;
  std::array<Count, 600> requests = {};  ///< By status.

  [[nodiscard]] Counters read() const;
};

}  // namespace tacit::gateway
