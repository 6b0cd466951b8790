#pragma once

#include <boost/asio/io_context.hpp>
#include <chrono>
#include <memory>
#include <set>
#include <utility>

#include "console/gateway/desk.h"
#include "console/gateway/server.h"
#include "console/gateway/sessions.h"
#include "console/gateway/tally.h"

namespace tacit::gateway {

using Clock = std::chrono::steady_clock;

inline Clock::duration seconds(double s) {
  return std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(s));
}

/// Something at a socket. All on the server's thread.
class Connection {
 public:
  virtual ~Connection() = default;
  /// Now and then, for what has taken too long.
  virtual void tick(Clock::time_point now) = 0;
  /// The server stops: ends soon, politely.
  virtual void shut() = 0;
  /// At once, without a word; nothing of it runs any more.
  virtual void abandon() = 0;
};

/// What a server's connections share. Owned by the server; who holds a weak pointer to it, on
/// whichever thread, may do no more than post.
struct Hub {
  explicit Hub(const ServerConfig& complete) : config(complete), desk(complete) {}
  Hub(const Hub&) = delete;
  Hub& operator=(const Hub&) = delete;
  ~Hub() { connections.clear(); }

  const ServerConfig config;
  Desk desk;
  Sessions sessions;
  std::shared_ptr<Tally> tally = std::make_shared<Tally>();
  std::set<std::shared_ptr<Connection>> connections;
  bool stopping = false;
  /// Goes first, and with it the connections that are held by what they wait for.
  boost::asio::io_context io{1};
};

/// Counts an open connection as long as it lives; an empty one does not.
class Ticket {
 public:
  Ticket() = default;
  explicit Ticket(std::shared_ptr<Tally> tally) : tally_(std::move(tally)) {
    ++tally_->connections_open;
    ++tally_->connections_total;
  }
  explicit operator bool() const { return tally_ != nullptr; }
  Ticket(Ticket&&) noexcept = default;
  Ticket& operator=(Ticket&&) = delete;
  ~Ticket() {
    if (tally_) {
      --tally_->connections_open;
    }
  }

 private:
  std::shared_ptr<Tally> tally_;
};

}  // namespace tacit::gateway
