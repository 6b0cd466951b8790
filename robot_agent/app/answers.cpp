#include "robot_agent/app/answers.h"

namespace tacit {

const Command* Answers::to(const Percept& percept) {
  if (last_ && percept.tick <= last_->tick) {
    ++duplicates_;
    return percept.tick == last_->tick ? &*last_ : nullptr;
  }
  last_ = decide_(percept);
  ++decisions_;
  return &*last_;
}

}  // namespace tacit
