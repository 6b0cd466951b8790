#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <utility>

#include "idl/types/plan_answer.h"

namespace tacit {

/// The last words of the wizard to the newest requests, for those that come again.
class Answered {
 public:
  /// Requests that are remembered, and bytes of their replies; the newest is always kept.
  static constexpr std::size_t kMost = 256;
  static constexpr std::size_t kMostBytes = 64'000'000;

  /// None when it was not answered or is forgotten. Valid until the next `keep`.
  [[nodiscard]] const WizardReply* find(std::uint64_t client, std::uint64_t number) const;
  void keep(WizardReply reply);

 private:
  struct Kept {
    WizardReply reply;
    std::size_t bytes = 0;
  };
  std::deque<Kept> kept_;  ///< The oldest first.
  std::size_t bytes_ = 0;
};

}  // namespace tacit
