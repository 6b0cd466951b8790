#pragma once

#include <string>
#include <vector>

#include "idl/types/plan_answer.h"
#include "wizard_service/cbr/plan.h"

namespace tacit::cbr {

/// A plan, what is said of it, and its text.
struct Proposal {
  Plan plan;
  OfferedPlan offered;
};

/// What a request is answered with.
struct Answer {
  std::vector<Proposal> proposals;  ///< Best first.
  std::vector<std::string> notes;   ///< What a person should know beside: sentences.
};

}  // namespace tacit::cbr
