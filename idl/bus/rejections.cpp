#include "idl/bus/rejections.h"

#include <spdlog/spdlog.h>

namespace tacit {

void Rejections::add(std::string_view topic, Flaw flaw) {
  std::uint64_t fresh = 0;
  {
    const std::lock_guard lock(mutex_);
    ++count_;
    const Clock::time_point now = Clock::now();
    if (now < next_word_) return;
    next_word_ = now + std::chrono::seconds(1);
    fresh = count_ - told_;
    told_ = count_;
  }
  spdlog::warn("{}: {} sample(s) refused, the last one because {}", topic, fresh, flaw.what);
}

std::uint64_t Rejections::count() const {
  const std::lock_guard lock(mutex_);
  return count_;
}

}  // namespace tacit
