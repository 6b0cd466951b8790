#pragma once

#include <mutex>
#include <span>
#include <utility>
#include <vector>

#include "idl/bus/bell.h"

namespace tacit {

/// Where a DDS thread leaves words for the thread of thought.
///
/// Words are swapped in and out, so that their memory is used again and again.
template <class Word>
class Mailbox {
 public:
  /// `bell` outlives the mailbox.
  explicit Mailbox(Bell& bell) : bell_(bell) {}

  /// Takes `word` over, leaving some old one in its place, and rings.
  void put(Word& word) {
    {
      const std::lock_guard lock(mutex_);
      if (count_ == waiting_.size()) waiting_.emplace_back();
      std::swap(waiting_[count_++], word);
    }
    bell_.ring();
  }

  /// All that came since the last call, in order. Valid until the next.
  [[nodiscard]] std::span<Word> collect() {
    const std::lock_guard lock(mutex_);
    std::swap(waiting_, taken_);
    return {taken_.data(), std::exchange(count_, 0)};
  }

 private:
  Bell& bell_;
  std::mutex mutex_;
  std::vector<Word> waiting_;
  std::size_t count_ = 0;
  std::vector<Word> taken_;
};

}  // namespace tacit
