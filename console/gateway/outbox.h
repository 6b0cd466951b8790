#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>

#include "console/gateway/limits.h"
#include "console/gateway/session.h"

namespace tacit::gateway {

/// One WebSocket message: a head of its own and a body that is shared.
struct Frame {
  bool binary = false;
  std::array<std::uint8_t, 13> head_bytes = {};
  std::size_t head_size = 0;
  std::shared_ptr<const void> owner;   ///< Of the body's bytes.
  std::span<const std::uint8_t> body;  ///< May be empty.

  [[nodiscard]] std::size_t size() const { return head_size + body.size(); }
};

[[nodiscard]] Frame text_frame(std::string text);
[[nodiscard]] Frame shared_frame(Payload bytes);

/// What waits to be sent to one client. For one thread at a time.
class Outbox {
 public:
  explicit Outbox(const Limits& limits);

  /// Goes before all telemetry and is never dropped.
  void push(Frame frame);
  /// May drop: first the oldest of the same channel, then the oldest of all. Returns how many.
  std::size_t push_message(ChannelId channel, Keep keep, Frame frame);
  /// Replaces a time that still waits.
  void set_time(Frame frame);
  /// Takes back what waits of a channel.
  void forget(ChannelId channel);
  [[nodiscard]] std::optional<Frame> pop();

  /// True when more control frames wait than a client that reads would ever leave.
  [[nodiscard]] bool is_overfull() const { return control_bytes_ > limits_.control_bytes; }
  [[nodiscard]] std::size_t bytes() const { return control_bytes_ + message_bytes_; }

 private:
  struct Message {
    ChannelId channel = 0;
    Frame frame;
  };
  using Number = std::uint64_t;

  void drop(Number number);

  Limits limits_;
  std::deque<Frame> control_;
  std::optional<Frame> time_;
  std::map<Number, Message> messages_;               ///< In the order of their coming.
  std::map<ChannelId, std::deque<Number>> waiting_;  ///< The same by channel; none is empty.
  Number next_ = 0;
  std::size_t control_bytes_ = 0;
  std::size_t message_bytes_ = 0;
};

}  // namespace tacit::gateway
