#pragma once

#include <chrono>
#include <cstdint>
#include <map>

#include "idl/bus/publisher.h"
#include "idl/types/plan_answer.h"

namespace tacit {

/// The ways back to clients, each made when it is first needed, so that what is said to one costs
/// the others nothing.
class ReplyBoxes {
 public:
  using Clock = std::chrono::steady_clock;
  /// A box that nobody reads and nothing went to for so long goes.
  static constexpr std::chrono::seconds kUnread{30};

  /// Borrows the participant.
  explicit ReplyBoxes(Participant& participant) : participant_(participant) {}

  /// Throws BusError when a box cannot be made.
  void put(const WizardReply& reply);
  /// Takes away what is no longer read.
  void tidy();

 private:
  struct Box {
    Publisher<topics::WizardReply> out;
    Clock::time_point used;
  };
  Participant& participant_;
  std::map<std::uint16_t, Box> boxes_;
};

}  // namespace tacit
