#pragma once

#include <chrono>
#include <cstdint>
#include <span>
#include <vector>

#include "idl/bus/bell.h"
#include "world_server/app/agent_port.h"
#include "world_server/app/barrier.h"

namespace tacit {

/// One tick of lock-step across a port that may lose, double and reorder: percepts go out, and go
/// out again, ever more rarely, to those whose command is late.
class Exchange {
 public:
  using Time = Bell::Clock::time_point;
  static constexpr std::chrono::milliseconds kFirstResend{20};
  static constexpr std::chrono::milliseconds kLongestPause{640};

  /// Both outlive this.
  Exchange(AgentPort& port, Barrier& barrier) : port_(port), barrier_(barrier) {}

  /// Sends `percepts` (robot i+1 at index i, valid until `end`) to the robots that are `present`.
  void begin(std::span<const Percept> percepts, const std::vector<bool>& present, Time now);
  [[nodiscard]] bool complete() const { return barrier_.complete(); }
  [[nodiscard]] Time resend_at() const { return resend_at_; }
  /// Sends the percept again to each robot whose command is missing, if that is due at `now`.
  void resend_if_due(Time now);
  /// The commands that came, in order of id. Valid until the next `begin`.
  [[nodiscard]] std::span<const Command> end() { return barrier_.close(); }

  /// Percepts sent again, in all.
  [[nodiscard]] std::uint32_t resent() const { return resent_; }

 private:
  AgentPort& port_;
  Barrier& barrier_;
  std::span<const Percept> percepts_;
  std::chrono::milliseconds pause_{kFirstResend};
  Time resend_at_{};
  std::uint32_t resent_ = 0;
};

}  // namespace tacit
