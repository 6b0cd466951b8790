#pragma once

#include <string>
#include <utility>
#include <vector>

#include "idl/types/plan_answer.h"

namespace tacit::cbr {

/// What has been changed so far, and what could not be.
class Changes {
 public:
  void adapt(std::string rule, std::string why, std::string before, std::string after) {
    add({PlanChange::Step::Adapt, std::move(rule), std::move(why), std::move(before),
         std::move(after), true});
  }
  void mend(std::string rule, std::string why, std::string before, std::string after) {
    add({PlanChange::Step::Criticize, std::move(rule), std::move(why), std::move(before),
         std::move(after), true});
  }
  /// It is likely to go wrong, and there is nothing to be done about it here.
  void warn(std::string rule, std::string why) {
    add({PlanChange::Step::Criticize, std::move(rule), std::move(why), {}, {}, false});
  }
  void add(const Changes& others) {
    changes_.insert(changes_.end(), others.changes_.begin(), others.changes_.end());
  }
  [[nodiscard]] const std::vector<PlanChange>& all() const { return changes_; }

 private:
  void add(PlanChange change) { changes_.push_back(std::move(change)); }

  std::vector<PlanChange> changes_;
};

}  // namespace tacit::cbr
