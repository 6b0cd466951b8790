#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
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
/// Only reads what is there for people, and writes Control; leaving changes nothing for the run.
class LiveRun {
 public:
  /// Throws BusError.
  LiveRun(std::shared_ptr<gateway::Session> session, const LiveRunFacts& facts);
  ~LiveRun();
  LiveRun(const LiveRun&) = delete;
  LiveRun& operator=(const LiveRun&) = delete;

  /// The newest; none before the world has told one. From any thread.
  [[nodiscard]] std::optional<RunStatus> status() const;
  /// Whether the world has said that the run ended or was stopped. From any thread.
  [[nodiscard]] bool over() const;
  /// Says it to the world server. From any thread.
  void say(const Control& control);

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace tacit
