#include "wizard_service/client/wizard_client.h"

#include <algorithm>
#include <optional>
#include <random>
#include <utility>

#include "idl/bus/bell.h"
#include "idl/bus/mailbox.h"
#include "idl/bus/publisher.h"
#include "idl/bus/subscriber.h"

namespace tacit {
namespace {

using std::chrono::milliseconds;
using Clock = Bell::Clock;

/// How soon it is noticed that a wizard is there, or that nobody wants an answer any more.
constexpr milliseconds kLook{5};
/// A wizard that is there and says nothing may have missed the request, or be busy with others'.
constexpr milliseconds kAskAgain{1000};
/// One that was killed and came back does not know a link that was made before.
constexpr milliseconds kNewLink{4000};

std::uint64_t random_id() {
  std::random_device chance;
  const std::uint64_t high = chance();
  return (high << 32 | chance()) | 1U;
}

Identity client_identity(int domain) {
  const std::uint64_t chance = random_id();
  const auto robot = static_cast<std::uint16_t>(chance >> 32);
  return {Party::Client, {robot}, domain, kWizardNonce, static_cast<std::uint32_t>(chance)};
}

/// This client on the bus.
struct Link {
  /// Only what is said to `id` goes into `mailbox`.
  Link(int domain, std::uint64_t id, Mailbox<WizardReply>& mailbox)
      : participant(client_identity(domain)),
        requests(participant),
        replies(participant, reply_box(id), [id, &mailbox](WizardReply& reply) {
          if (reply.client == id) mailbox.put(reply);
        }) {}
  /// The wizard makes the way back when it is asked.
  [[nodiscard]] bool stands() const { return requests.readers() > 0; }

  Participant participant;
  Publisher<topics::WizardRequest> requests;
  Subscriber<topics::WizardReply> replies;
};

}  // namespace

class WizardClient::Impl {
 public:
  explicit Impl(const Settings& settings) : settings_(settings), mailbox_(bell_) { join(); }

  Reply ask(What what, const Progress& progress, const Cancelled& cancelled) {
    const WizardRequest request{id_, ++number_, std::move(what)};
    const Clock::time_point began = Clock::now();
    Clock::time_point heard = began;
    Clock::time_point joined = began;
    std::optional<Clock::time_point> asked;
    for (;;) {
      if (cancelled && cancelled()) return WizardRefusal{"cancelled"};
      const Clock::time_point now = Clock::now();
      if (now - heard > settings_.patience) throw WizardSilent(silence());
      if (now - std::max(heard, joined) > kNewLink) {
        join();
        joined = now;
        asked.reset();
      }
      if (link_->stands() && (!asked || now - *asked > kAskAgain)) {
        link_->requests.publish(request);
        asked = now;
      }
      bell_.wait_until(now + kLook);
      for (WizardReply& reply : mailbox_.collect()) {
        if (reply.number != number_) continue;
        heard = Clock::now();
        if (auto* under_way = std::get_if<WizardProgress>(&reply.what)) {
          if (progress) progress(*under_way);
        } else {
          return last_word(reply);
        }
      }
    }
  }

  [[nodiscard]] std::uint64_t id() const { return id_; }

 private:
  void join() {
    link_.reset();
    link_ = std::make_unique<Link>(settings_.domain, id_, mailbox_);
  }

  static Reply last_word(WizardReply& reply) {
    if (auto* plans = std::get_if<PlanAnswer>(&reply.what)) return std::move(*plans);
    if (auto* done = std::get_if<WizardDone>(&reply.what)) return std::move(*done);
    return std::move(std::get<WizardRefusal>(reply.what));
  }

  [[nodiscard]] std::string silence() const {
    const double patience_s = std::chrono::duration<double>(settings_.patience).count();
    std::string seconds = std::to_string(patience_s);
    seconds.erase(seconds.find('.') + 2);
    return "no wizard said anything on domain " + std::to_string(settings_.domain) + " within " +
           seconds + " s";
  }

  Settings settings_;
  std::uint64_t id_ = random_id();
  std::uint64_t number_ = 0;
  Bell bell_;
  Mailbox<WizardReply> mailbox_;
  std::unique_ptr<Link> link_;
};

WizardClient::WizardClient(const Settings& settings) : impl_(std::make_unique<Impl>(settings)) {}
WizardClient::~WizardClient() = default;
WizardClient::WizardClient(WizardClient&&) noexcept = default;
WizardClient& WizardClient::operator=(WizardClient&&) noexcept = default;

WizardClient::Reply WizardClient::ask(What what, const Progress& progress,
                                      const Cancelled& cancelled) {
  return impl_->ask(std::move(what), progress, cancelled);
}

std::uint64_t WizardClient::id() const { return impl_->id(); }

}  // namespace tacit
