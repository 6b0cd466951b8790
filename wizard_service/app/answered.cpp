#include "wizard_service/app/answered.h"

#include <algorithm>
#include <variant>

namespace tacit {
namespace {

/// Of what grows without bounds; the rest is a few hundred bytes.
std::size_t bytes_of(const WizardReply& reply) {
  std::size_t bytes = sizeof reply;
  if (const auto* answer = std::get_if<PlanAnswer>(&reply.what)) {
    for (const OfferedPlan& plan : answer->plans) {
      bytes += plan.mission.size() + sizeof plan;
      for (const PlanChange& change : plan.changes) {
        bytes += sizeof change + change.why.size() + change.before.size() + change.after.size();
      }
    }
  }
  return bytes;
}

}  // namespace

const WizardReply* Answered::find(std::uint64_t client, std::uint64_t number) const {
  const auto at = std::find_if(kept_.begin(), kept_.end(), [&](const Kept& kept) {
    return kept.reply.client == client && kept.reply.number == number;
  });
  return at == kept_.end() ? nullptr : &at->reply;
}

void Answered::keep(WizardReply reply) {
  const std::size_t bytes = bytes_of(reply);
  kept_.push_back({std::move(reply), bytes});
  bytes_ += bytes;
  while (kept_.size() > 1 && (kept_.size() > kMost || bytes_ > kMostBytes)) {
    bytes_ -= kept_.front().bytes;
    kept_.pop_front();
  }
}

}  // namespace tacit
