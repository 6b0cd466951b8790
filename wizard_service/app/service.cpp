#include "wizard_service/app/service.h"

#include <spdlog/spdlog.h>

#include <atomic>
#include <chrono>
#include <thread>
#include <utility>

namespace tacit {
namespace {

/// Clients that are remembered; of one that is forgotten only the last answers are lost.
constexpr std::size_t kMostQueues = 10'000;

}  // namespace

/// A desk, its post and who works at it.
class WizardService::Clerk {
 public:
  Clerk(std::unique_ptr<cbr::CaseBase> base, Desk::Say say)
      : base_(std::move(base)), desk_(*base_), say_(std::move(say)), requests_(bell_) {}
  ~Clerk() {
    home_ = true;
    bell_.ring();
    if (thread_.joinable()) thread_.join();
  }
  Clerk(const Clerk&) = delete;
  Clerk& operator=(const Clerk&) = delete;

  void begin() {
    thread_ = std::thread([this] { work(); });
  }
  void put(WizardRequest& request) { requests_.put(request); }

 private:
  void work() {
    while (!home_) {
      bell_.wait();
      for (const WizardRequest& request : requests_.collect()) {
        if (home_) return;
        desk_.take(request, say_);
      }
    }
  }

  std::unique_ptr<cbr::CaseBase> base_;
  Desk desk_;
  Desk::Say say_;
  Bell bell_;
  Mailbox<WizardRequest> requests_;
  std::atomic<bool> home_{false};
  std::thread thread_;
};

WizardService::WizardService(std::vector<std::unique_ptr<cbr::CaseBase>> bases, int domain)
    : post_(domain),
      signals_(bell_),
      participant_({Party::Wizard, {}, domain, kWizardNonce, 0}),
      replies_(participant_),
      clerks_([&] {
        std::vector<std::unique_ptr<Clerk>> clerks;
        for (std::unique_ptr<cbr::CaseBase>& base : bases) {
          clerks.push_back(std::make_unique<Clerk>(
              std::move(base), [this](const WizardReply& reply) { say(reply); }));
        }
        return clerks;
      }()),
      requests_in_(participant_, {},
                   [this](WizardRequest& request) { clerk_of(request.client).put(request); }) {}

WizardService::~WizardService() = default;

WizardService::Clerk& WizardService::clerk_of(std::uint64_t client) {
  if (queues_.size() >= kMostQueues) queues_.clear();
  const auto [at, fresh] = queues_.try_emplace(client, queues_.size() % clerks_.size());
  return *clerks_[at->second];
}

void WizardService::say(const WizardReply& reply) {
  if (const auto* refusal = std::get_if<WizardRefusal>(&reply.what)) {
    spdlog::info("client {:x}, request {}: refused: {}", reply.client, reply.number, refusal->text);
  }
  const std::lock_guard lock(replies_mutex_);
  replies_.put(reply);
}

void WizardService::run() {
  for (const std::unique_ptr<Clerk>& clerk : clerks_) clerk->begin();
  std::uint64_t rejected = 0;
  while (!StopSignals::came()) {
    bell_.wait_until(Bell::Clock::now() + std::chrono::seconds(1));
    {
      const std::lock_guard lock(replies_mutex_);
      replies_.tidy();
    }
    if (participant_.rejections().count() != rejected) {
      rejected = participant_.rejections().count();
      spdlog::warn("{} samples were refused so far", rejected);
    }
  }
}

}  // namespace tacit
