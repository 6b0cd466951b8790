#include "console/gateway/outbox.h"

#include <utility>

namespace tacit::gateway {

Frame text_frame(std::string text) {
  const auto owner = std::make_shared<const std::string>(std::move(text));
  Frame frame;
  frame.body = {reinterpret_cast<const std::uint8_t*>(owner->data()), owner->size()};
  frame.owner = owner;
  return frame;
}

Frame shared_frame(Payload bytes) {
  Frame frame;
  frame.binary = true;
  if (bytes) {
    frame.body = *bytes;
    frame.owner = std::move(bytes);
  }
  return frame;
}

Outbox::Outbox(const Limits& limits) : limits_(limits) {}

void Outbox::push(Frame frame) {
  control_bytes_ += frame.size();
  control_.push_back(std::move(frame));
}

std::size_t Outbox::push_message(ChannelId channel, Keep keep, Frame frame) {
  std::size_t dropped = 0;
  const std::size_t most = keep == Keep::Latest ? limits_.queue_latest : limits_.queue_all;
  const auto same = [&] { return waiting_.find(channel); };
  while (same() != waiting_.end() && same()->second.size() >= most) {
    drop(same()->second.front());
    ++dropped;
  }
  while (!messages_.empty() && message_bytes_ + frame.size() > limits_.queue_bytes) {
    drop(same() != waiting_.end() ? same()->second.front() : messages_.begin()->first);
    ++dropped;
  }
  message_bytes_ += frame.size();
  waiting_[channel].push_back(next_);
  messages_.emplace(next_++, Message{channel, std::move(frame)});
  return dropped;
}

void Outbox::set_time(Frame frame) { time_ = std::move(frame); }

void Outbox::forget(ChannelId channel) {
  for (auto of = waiting_.find(channel); of != waiting_.end(); of = waiting_.find(channel)) {
    drop(of->second.front());
  }
}

std::optional<Frame> Outbox::pop() {
  if (!control_.empty()) {
    Frame frame = std::move(control_.front());
    control_.pop_front();
    control_bytes_ -= frame.size();
    return frame;
  }
  if (time_) {
    return std::exchange(time_, std::nullopt);
  }
  if (messages_.empty()) {
    return std::nullopt;
  }
  Frame frame = messages_.begin()->second.frame;
  drop(messages_.begin()->first);
  return frame;
}

/// `number` is the oldest of its channel.
void Outbox::drop(Number number) {
  const auto message = messages_.find(number);
  const auto of = waiting_.find(message->second.channel);
  of->second.pop_front();
  if (of->second.empty()) {
    waiting_.erase(of);
  }
  message_bytes_ -= message->second.frame.size();
  messages_.erase(message);
}

}  // namespace tacit::gateway
