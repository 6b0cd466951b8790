#pragma once

#include <functional>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "idl/bus/bell.h"
#include "idl/bus/cdr.h"
#include "idl/bus/mailbox.h"
#include "idl/bus/participant.h"
#include "idl/bus/raw_subscriber.h"

namespace tacit {

/// Hears all that a run tells the console, as bytes and as words. For one thread.
class RunListener {
 public:
  /// What to hear of where bodies are.
  enum class Views {
    None,
    SomeTimesASecond,  ///< World views.
    EveryTick,         ///< Trajectories.
  };
  using Bytes = std::span<const std::uint8_t>;
  /// Valid until it returns.
  template <class Word>
  using Take = std::function<void(const Word&, Bytes)>;

  /// `bell` rings when something has come, and outlives the listener. Throws BusError.
  RunListener(const Identity& identity, std::int64_t robots, Views views, Bell& bell);

  /// Each gives what came since the last call, in order.
  void events(const Take<EventBatch>& take) { hear(events_, event_batch_, take); }
  void views(const Take<WorldView>& take) { hear(views_, view_, take); }
  void status(const Take<RunStatus>& take) { hear(status_, run_status_, take); }
  void telemetry(const Take<Telemetry>& take);

  /// "4 ClearToEnemy, 2 AllClear": the robots by the role or situation each told last; empty when
  /// none has told one.
  [[nodiscard]] std::string doings() const;

 private:
  template <class Word>
  void hear(Mailbox<RawSample>& mailbox, Word& word, const Take<Word>& take) {
    for (const RawSample& sample : mailbox.collect()) {
      if (const Flaw flaw = from_cdr(sample.bytes, word)) {
        participant_.rejections().add("what the run tells people", flaw);
      } else {
        take(word, sample.bytes);
      }
    }
  }

  Mailbox<RawSample> events_;
  Mailbox<RawSample> views_;
  Mailbox<RawSample> status_;
  Mailbox<RawSample> telemetry_;
  EventBatch event_batch_;
  WorldView view_;
  RunStatus run_status_;
  Telemetry telemetry_word_;
  std::map<RobotId, std::string> doing_;
  Participant participant_;
  RawSubscriber<topics::Events> events_in_;
  RawSubscriber<topics::Status> status_in_;
  std::optional<RawSubscriber<topics::WorldView>> view_in_;
  std::optional<RawSubscriber<topics::Trajectory>> trajectory_in_;
  std::vector<RawSubscriber<topics::Telemetry>> telemetry_in_;
};

}  // namespace tacit
