#include "wizard_service/app/reply_boxes.h"

namespace tacit {

void ReplyBoxes::put(const WizardReply& reply) {
  const RobotId number = reply_box(reply.client);
  auto at = boxes_.find(number.value);
  if (at == boxes_.end()) {
    at = boxes_.emplace(number.value, Box{Publisher<topics::WizardReply>(participant_, number), {}})
             .first;
  }
  at->second.out.publish(reply);
  at->second.used = Clock::now();
}

void ReplyBoxes::tidy() {
  const Clock::time_point now = Clock::now();
  std::erase_if(boxes_, [&](const auto& entry) {
    return entry.second.out.readers() == 0 && now - entry.second.used > kUnread;
  });
}

}  // namespace tacit
