#include "world_server/app/exchange.h"

#include <algorithm>
#include <cassert>

namespace tacit {

void Exchange::begin(std::span<const Percept> percepts, const std::vector<bool>& present,
                     Time now) {
  assert(percepts.size() == present.size() && !percepts.empty());
  percepts_ = percepts;
  pause_ = kFirstResend;
  resend_at_ = now + pause_;
  barrier_.open(percepts.front().tick, present);
  for (std::size_t i = 0; i < percepts.size(); ++i) {
    if (present[i]) port_.send(percepts[i]);
  }
}

void Exchange::resend_if_due(Time now) {
  if (now < resend_at_) return;
  for (const RobotId robot : barrier_.missing()) {
    port_.send(percepts_[static_cast<std::size_t>(robot.value) - 1]);
    ++resent_;
  }
  pause_ = std::min(pause_ * 2, kLongestPause);
  resend_at_ = now + pause_;
}

}  // namespace tacit
