#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

#include "idl/bus/mailbox.h"
#include "idl/bus/participant.h"
#include "idl/topics/topics.h"

namespace tacit {

/// A sample as it came over the bus, its contents looked at by nobody.
struct RawSample {
  RobotId robot;  ///< Of a robot's topic; else 0.
  /// CDR: 4 bytes that name the encoding, then the wire type's members. `from_cdr` reads it.
  std::vector<std::uint8_t> bytes;
};

/// Receives the samples of one topic for people as bytes, with the promise that the topic makes.
///
/// A wire type is either read as words or as bytes by one participant: a second reader of the other
/// kind is a BusError. WorldView and Trajectory are of one wire type.
template <class Topic>
class RawSubscriber {
  static_assert(Topic::kReaders.contains(Party::Console), "only what is there for people");

 public:
  /// Runs on a thread of the bus, which reads nothing else of this topic until it returns; it may
  /// take the sample's contents.
  using Take = std::function<void(RawSample&)>;

  /// `robot` counts for a robot's topic alone. Throws BusError.
  RawSubscriber(Participant& participant, RobotId robot, Take take);
  /// Every sample goes into `mailbox`, which outlives this.
  RawSubscriber(Participant& participant, RobotId robot, Mailbox<RawSample>& mailbox)
      : RawSubscriber(participant, robot, [&mailbox](RawSample& sample) { mailbox.put(sample); }) {}
  ~RawSubscriber();
  RawSubscriber(RawSubscriber&&) noexcept;
  RawSubscriber& operator=(RawSubscriber&&) noexcept;

  /// Writers that are there now. From any thread.
  [[nodiscard]] int writers() const;

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace tacit
