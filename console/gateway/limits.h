#pragma once

#include <cstddef>

namespace tacit::gateway {

/// What clients may ask of a server. Beyond a limit they are refused, or closed.
struct Limits {
  std::size_t connections = 256;       ///< WebSockets included; 503 beyond.
  std::size_t header_bytes = 16384;    ///< Of a request; 431 beyond.
  std::size_t body_bytes = 4U << 20U;  ///< Of a request; 413 beyond.
  double header_s = 10.0;              ///< For the header of a request.
  double idle_s = 60.0;                ///< Between requests of one connection.
  double body_s = 30.0;                ///< For the body of a request, and for taking the answer.
  double answer_s = 60.0;              ///< For handlers that answer later; 504 beyond.

  std::size_t message_bytes = 1U << 20U;  ///< Of a client's WebSocket message; closed with 1009.
  double messages_per_s = 200.0;          ///< Of one client; beyond, they are read more slowly.
  std::size_t calls = 64;                 ///< Service calls of a client without an answer yet.
  double silence_s = 30.0;                ///< Closed when nothing came for so long, pongs included.
  double stalled_s = 10.0;                ///< Closed when a message could not be sent for so long.
  std::size_t queue_latest = 16;          ///< Messages that wait, per client and channel.
  std::size_t queue_all = 4096;           ///< The same for Keep::All.
  std::size_t queue_bytes = 8U << 20U;    ///< Of messages that wait, per client.
  std::size_t control_bytes = 16U << 20U;  ///< Of all else that waits; closed beyond.

  double stop_s = 2.0;  ///< For saying good-bye when the server stops.
};

}  // namespace tacit::gateway
