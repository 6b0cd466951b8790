#pragma once

#include <chrono>
#include <memory>

#include "idl/bus/participant.h"
#include "idl/topics/topics.h"

namespace tacit {

/// Sends the words of one topic. For one thread.
template <class Topic>
class Publisher {
 public:
  using Word = typename Topic::Word;

  /// `robot` counts for a robot's topic alone; `promise` is the topic's, or `Answer` in place of
  /// `EveryTick`, which its readers take as well. Throws BusError.
  explicit Publisher(Participant& participant, RobotId robot = {},
                     Promise promise = Topic::kPromise);
  ~Publisher();
  Publisher(Publisher&&) noexcept;
  Publisher& operator=(Publisher&&) noexcept;

  /// Sends within this call, by the calling thread. False if the bus did not take the word, which
  /// only a topic without gaps does, when its readers are too slow for seconds on end, and one of
  /// every tick, when a reader was killed. Throws what the bus throws, except on the latter.
  bool publish(const Word& word);

  /// Readers that are there now. From any thread.
  [[nodiscard]] int readers() const;

  /// Waits until every reader that is there has all that was published; false if that took longer.
  [[nodiscard]] bool wait_received(std::chrono::milliseconds patience);

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace tacit
