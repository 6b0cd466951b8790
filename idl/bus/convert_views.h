#pragma once

#include "idl/bus/sieve.h"
#include "idl/types/telemetry.h"
#include "idl/types/world_view.h"

namespace tacit {

namespace wire {
class WorldView;
class Telemetry;
}  // namespace wire

/// Words to wire and back, as in convert_lockstep.h. Of lists that are longer than the word allows
/// only the beginning goes out: a spectator's picture may be short, a run may not end over it.

void to_wire(const WorldView& word, wire::WorldView& wire);
[[nodiscard]] Flaw from_wire(const wire::WorldView& wire, WorldView& word);

void to_wire(const Telemetry& word, wire::Telemetry& wire);
[[nodiscard]] Flaw from_wire(const wire::Telemetry& wire, Telemetry& word);

}  // namespace tacit
