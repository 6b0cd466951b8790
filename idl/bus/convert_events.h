#pragma once

#include "idl/bus/sieve.h"
#include "idl/types/event_batch.h"

namespace tacit {

namespace wire {
class EventBatch;
}  // namespace wire

/// Words to wire and back, as in convert_lockstep.h.

void to_wire(const EventBatch& word, wire::EventBatch& wire);
[[nodiscard]] Flaw from_wire(const wire::EventBatch& wire, EventBatch& word);

}  // namespace tacit
