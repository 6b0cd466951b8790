#include "world_server/app/event_log.h"

#include <algorithm>

namespace tacit {

void EventLog::add(std::span<const Event> events) {
  while (!events.empty()) {
    const std::span<const Event> now =
        events.first(std::min(events.size(), EventBatch::kMaxEvents));
    batch_.first = size_;
    batch_.events.assign(now.begin(), now.end());
    out_.publish(batch_);
    size_ += now.size();
    events = events.subspan(now.size());
  }
}

}  // namespace tacit
