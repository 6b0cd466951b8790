#pragma once

#include "idl/bus/sieve.h"
#include "idl/types/plan_answer.h"
#include "idl/types/plan_request.h"

namespace tacit {

namespace wire {
class WizardRequest;
class WizardReply;
}  // namespace wire

/// Words to wire and back, as in convert_lockstep.h. What is too long is cut on the way out and
/// refused on the way in. Of a request, only what no person could have meant is refused; what is
/// wrong with a plan's wishes is for the wizard to say.

void to_wire(const WizardRequest& word, wire::WizardRequest& wire);
[[nodiscard]] Flaw from_wire(const wire::WizardRequest& wire, WizardRequest& word);

void to_wire(const WizardReply& word, wire::WizardReply& wire);
[[nodiscard]] Flaw from_wire(const wire::WizardReply& wire, WizardReply& word);

}  // namespace tacit
