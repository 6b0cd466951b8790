#pragma once

#include <chrono>
#include <cstdint>
#include <mutex>
#include <string_view>

#include "idl/bus/sieve.h"

namespace tacit {

/// Counts the samples that were refused and warns on standard error at most once a second.
class Rejections {
 public:
  /// From any thread.
  void add(std::string_view topic, Flaw flaw);
  [[nodiscard]] std::uint64_t count() const;

 private:
  using Clock = std::chrono::steady_clock;

  mutable std::mutex mutex_;
  std::uint64_t count_ = 0;
  std::uint64_t told_ = 0;
  Clock::time_point next_word_{};
};

}  // namespace tacit
