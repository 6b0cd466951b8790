#pragma once

#include <cstdint>
#include <span>

#include "idl/bus/publisher.h"
#include "idl/types/event_batch.h"

namespace tacit {

/// The run's event log as it goes out to whoever records it.
class EventLog {
 public:
  explicit EventLog(Participant& participant) : out_(participant) {}

  void add(std::span<const Event> events);
  [[nodiscard]] std::uint64_t size() const { return size_; }
  [[nodiscard]] int readers() const { return out_.readers(); }
  /// Waits until every reader that is there has the whole log; false if that took longer.
  [[nodiscard]] bool wait_received(std::chrono::milliseconds patience) {
    return out_.wait_received(patience);
  }

 private:
  Publisher<topics::Events> out_;
  EventBatch batch_;
  std::uint64_t size_ = 0;
};

}  // namespace tacit
