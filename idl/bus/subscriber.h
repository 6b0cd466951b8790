#pragma once

#include <functional>
#include <memory>

#include "idl/bus/mailbox.h"
#include "idl/bus/participant.h"
#include "idl/topics/topics.h"

namespace tacit {

/// Receives the words of one topic. Samples that `from_wire` refuses are counted in the
/// participant's rejections and go no further.
template <class Topic>
class Subscriber {
 public:
  using Word = typename Topic::Word;
  /// Runs on a thread of the bus, which reads nothing else of this topic until it returns; it may
  /// take the word's contents.
  using Take = std::function<void(Word&)>;

  /// `robot` counts for a robot's topic alone. Throws BusError.
  Subscriber(Participant& participant, RobotId robot, Take take);
  /// Every word goes into `mailbox`, which outlives this.
  Subscriber(Participant& participant, RobotId robot, Mailbox<Word>& mailbox)
      : Subscriber(participant, robot, [&mailbox](Word& word) { mailbox.put(word); }) {}
  ~Subscriber();
  Subscriber(Subscriber&&) noexcept;
  Subscriber& operator=(Subscriber&&) noexcept;

  /// Writers that are there now. From any thread.
  [[nodiscard]] int writers() const;

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace tacit
