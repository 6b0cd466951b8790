#include "console/gateway/tally.h"

namespace tacit::gateway {

Counters Tally::read() const {
  Counters counters;
  counters.connections_open = connections_open;
  counters.connections_total = connections_total;
  counters.connections_refused = connections_refused;
  counters.websockets_open = websockets_open;
  counters.websockets_total = websockets_total;
  counters.websockets_stalled = websockets_stalled;
  counters.messages_sent = messages_sent;
  counters.messages_dropped = messages_dropped;
  counters.messages_received = messages_received;
  counters.bytes_sent = bytes_sent;
  counters.bytes_received = bytes_received;
  for (std::size_t status = 0; status < requests.size(); ++status) {
    if (const std::uint64_t count = requests.at(status); count > 0) {
      counters.requests_by_status[static_cast<int>(status)] = count;
    }
  }
  return counters;
}

}  // namespace tacit::gateway
