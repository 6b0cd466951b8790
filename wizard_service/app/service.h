#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <mutex>
#include <vector>

#include "idl/bus/bell.h"
#include "idl/bus/mailbox.h"
#include "idl/bus/stop_signals.h"
#include "idl/bus/subscriber.h"
#include "idl/bus/wizard_post.h"
#include "wizard_service/app/desk.h"
#include "wizard_service/app/reply_boxes.h"

namespace tacit {

/// Desks on the bus, each with a thread of its own. A client always comes to the same desk, so that
/// one request of it is done after the other, and one that comes again is known.
class WizardService {
 public:
  /// A desk for each of `bases`, which are of one file. Throws BusError when there is a wizard on
  /// the domain already or the bus cannot be set up.
  WizardService(std::vector<std::unique_ptr<cbr::CaseBase>> bases, int domain);
  ~WizardService();

  /// Answers until SIGINT or SIGTERM.
  void run();

 private:
  class Clerk;

  void say(const WizardReply& reply);
  /// For the thread that requests come in on.
  [[nodiscard]] Clerk& clerk_of(std::uint64_t client);

  WizardPost post_;
  Bell bell_;
  StopSignals signals_;
  Participant participant_;
  std::mutex replies_mutex_;
  ReplyBoxes replies_;
  std::vector<std::unique_ptr<Clerk>> clerks_;
  std::map<std::uint64_t, std::size_t> queues_;  ///< Which clerk a client comes to.
  Subscriber<topics::WizardRequest> requests_in_;
};

}  // namespace tacit
