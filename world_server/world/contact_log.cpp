#include "world_server/world/contact_log.h"

namespace tacit {

std::span<const Contact> ContactLog::begun(std::span<const Contact> now, Tick tick) {
  begun_.clear();
  merged_.clear();
  auto old = recent_.begin();
  const auto keep_while = [&](auto before) {
    for (; old != recent_.end() && before(old->contact); ++old) {
      if (tick - old->last < kApartTicks) {
        merged_.push_back(*old);
      }
    }
  };
  for (const Contact& contact : now) {
    keep_while([&contact](const Contact& c) { return c < contact; });
    const bool lasting = old != recent_.end() && old->contact == contact;
    if (!lasting || tick - old->last >= kApartTicks) {
      begun_.push_back(contact);
    }
    if (lasting) {
      ++old;
    }
    merged_.push_back({contact, tick});
  }
  keep_while([](const Contact&) { return true; });
  recent_.swap(merged_);
  return begun_;
}

}  // namespace tacit
