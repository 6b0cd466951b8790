#pragma once

#include "idl/bus/sieve.h"
#include "idl/types/roster.h"

namespace tacit {

namespace wire {
class Order;
class Hello;
class Control;
class RunStatus;
}  // namespace wire

/// Words to wire and back, as in convert_lockstep.h. A text that is longer than its member may be
/// is cut on the way out and refused on the way in.

void to_wire(const Order& word, wire::Order& wire);
[[nodiscard]] Flaw from_wire(const wire::Order& wire, Order& word);

void to_wire(const Hello& word, wire::Hello& wire);
[[nodiscard]] Flaw from_wire(const wire::Hello& wire, Hello& word);

void to_wire(const Control& word, wire::Control& wire);
[[nodiscard]] Flaw from_wire(const wire::Control& wire, Control& word);

void to_wire(const RunStatus& word, wire::RunStatus& wire);
[[nodiscard]] Flaw from_wire(const wire::RunStatus& wire, RunStatus& word);

}  // namespace tacit
