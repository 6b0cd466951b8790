#include "idl/bus/bell.h"

#include <linux/futex.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <cerrno>
#include <ctime>

namespace tacit {
namespace {

static_assert(std::atomic<std::uint32_t>::is_always_lock_free);

long futex(std::atomic<std::uint32_t>& word, int operation, std::uint32_t value,
           const timespec* until) {
  return syscall(SYS_futex, &word, operation | FUTEX_PRIVATE_FLAG, value, until, nullptr,
                 FUTEX_BITSET_MATCH_ANY);
}

/// The steady clock is CLOCK_MONOTONIC, which FUTEX_WAIT_BITSET counts by.
timespec to_timespec(Bell::Clock::time_point time) {
  const auto ns =
      std::chrono::duration_cast<std::chrono::nanoseconds>(time.time_since_epoch()).count();
  return {static_cast<time_t>(ns / 1'000'000'000), static_cast<long>(ns % 1'000'000'000)};
}

}  // namespace

void Bell::ring() {
  if (state_.exchange(kRung, std::memory_order_acq_rel) == kAsleep) {
    const int saved = errno;
    futex(state_, FUTEX_WAKE, 1, nullptr);
    errno = saved;
  }
}

bool Bell::wait_until(Clock::time_point until) { return sleep(&until); }

void Bell::wait() {
  while (!sleep(nullptr)) {
  }
}

bool Bell::take_ring() { return state_.exchange(kQuiet, std::memory_order_acq_rel) == kRung; }

bool Bell::sleep(const Clock::time_point* until) {
  std::uint32_t quiet = kQuiet;
  if (!state_.compare_exchange_strong(quiet, kAsleep, std::memory_order_acq_rel)) {
    return take_ring();
  }
  const timespec end = until != nullptr ? to_timespec(*until) : timespec{};
  long slept = 0;
  do {
    slept = futex(state_, FUTEX_WAIT_BITSET, kAsleep, until != nullptr ? &end : nullptr);
  } while (slept != 0 && errno == EINTR && state_.load(std::memory_order_acquire) == kAsleep);
  return take_ring();
}

}  // namespace tacit
