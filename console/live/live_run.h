#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "console/gateway/session.h"
#include "idl/bus/venue_file.h"
#include "idl/types/roster.h"

namespace tacit {

/// A run that goes on somewhere on the bus.
struct LiveRunFacts {
  Venue venue;
  std::int64_t robots = 0;
  double tick_s = 0.1;  ///< Simulated time per tick.
};

/// A run as a session of the gateway: its topics for people as channels, byte for byte, and what an
/// operator can say to it as services.
///
/// Only reads what is there for people, and writes Control; leaving changes nothing for the run. It
/// reads while somebody watches and for a while after: a reader costs the run's own processes time.
class LiveRun {
 public:
  /// Throws BusError.
  LiveRun(std::shared_ptr<gateway::Session> session, const LiveRunFacts& facts);
  ~LiveRun();
  LiveRun(const LiveRun&) = delete;
  LiveRun& operator=(const LiveRun&) = delete;

  /// Begins to read when the session has clients, and ends when it has had none for some seconds.
  /// To be called a few times a second, by one thread. Throws BusError.
  void look();
  /// Says it to the world server. From any thread.
  void say(const Control& control);

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace tacit
