#pragma once

#include <cstdint>
#include <map>

namespace tacit::gateway {

/// What a server has done since it was made, and how many it serves now.
struct Counters {
  std::uint64_t connections_open = 0;     ///< Now, WebSockets included.
  std::uint64_t connections_total = 0;    ///< Accepted, those beyond the limit excluded.
  std::uint64_t connections_refused = 0;  ///< Beyond the limit.
  std::uint64_t websockets_open = 0;      ///< Now.
  std::uint64_t websockets_total = 0;
  std::uint64_t websockets_stalled = 0;             ///< Closed because the client did not read.
  std::uint64_t messages_sent = 0;                  ///< Over WebSockets, of any kind.
  std::uint64_t messages_dropped = 0;               ///< Telemetry that a client was too slow for.
  std::uint64_t messages_received = 0;              ///< From WebSocket clients.
  std::uint64_t bytes_sent = 0;                     ///< Payloads of WebSocket messages.
  std::uint64_t bytes_received = 0;                 ///< Payloads of WebSocket messages.
  std::map<int, std::uint64_t> requests_by_status;  ///< 101 stands for upgrades.
};

}  // namespace tacit::gateway
