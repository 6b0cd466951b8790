#pragma once

#include <atomic>
#include <chrono>
#include <cstdint>

namespace tacit {

/// Wakes one sleeping thread. A ring while nobody sleeps is remembered; several count as one.
class Bell {
 public:
  using Clock = std::chrono::steady_clock;

  /// From any thread, also from a signal handler.
  void ring();

  /// Returns at once if the bell has rung since the last wait, else sleeps until it rings or
  /// `until` has come. True if it rang. For one thread only.
  bool wait_until(Clock::time_point until);
  /// The same without an end.
  void wait();

 private:
  enum State : std::uint32_t { kQuiet, kRung, kAsleep };

  bool take_ring();
  bool sleep(const Clock::time_point* until);

  std::atomic<std::uint32_t> state_{kQuiet};
};

}  // namespace tacit
