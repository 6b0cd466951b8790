#pragma once

#include "idl/bus/sieve.h"
#include "idl/types/command.h"
#include "idl/types/percept.h"

namespace tacit {

namespace wire {
class Percept;
class Command;
}  // namespace wire

/// Words to wire and back. `from_wire` refuses what is not a number, out of range, of an unknown
/// kind or too long, and says why; what it then left in `word` means nothing.

void to_wire(const Percept& word, wire::Percept& wire);
[[nodiscard]] Flaw from_wire(const wire::Percept& wire, Percept& word);

void to_wire(const Command& word, wire::Command& wire);
[[nodiscard]] Flaw from_wire(const wire::Command& wire, Command& word);

}  // namespace tacit
