#include "idl/bus/convert_events.h"

#include <cassert>
#include <variant>

#include "idl/bus/event_reader.h"
#include "idl/bus/event_writer.h"
#include "idl/wire/team.h"

namespace tacit {
namespace {

/// The position of a happening's type in `Happening` is its code on the wire.
template <std::size_t Index>
using HappeningAt = std::variant_alternative_t<Index, Happening>;

/// Makes `what` hold a fresh happening of the type with code `kind`; false when there is none.
template <std::size_t Index = 0>
bool hold(std::uint8_t kind, Happening& what) {
  if constexpr (Index == std::variant_size_v<Happening>) {
    return false;
  } else {
    if (kind != Index) return hold<Index + 1>(kind, what);
    what = HappeningAt<Index>{};
    return true;
  }
}

void to_wire(const Event& word, wire::Event& wire) {
  wire = wire::Event();
  wire.tick(word.tick);
  wire.kind(static_cast<std::uint8_t>(word.what.index()));
  std::visit(EventWriter(wire), word.what);
}

void from_wire(Sieve& sieve, const wire::Event& wire, Event& word) {
  word.tick = sieve_tick(sieve, wire.tick());
  if (sieve.pass(hold(wire.kind(), word.what), "unknown kind of event")) {
    std::visit(EventReader(sieve, wire), word.what);
  }
}

}  // namespace

void to_wire(const EventBatch& word, wire::EventBatch& wire) {
  assert(word.events.size() <= EventBatch::kMaxEvents);
  wire.first(word.first);
  wire.events().resize(word.events.size());
  for (std::size_t i = 0; i < word.events.size(); ++i) to_wire(word.events[i], wire.events()[i]);
}

Flaw from_wire(const wire::EventBatch& wire, EventBatch& word) {
  Sieve sieve;
  word.first = wire.first();
  word.events.resize(
      sieve.count(wire.events().size(), EventBatch::kMaxEvents, "more events than a batch holds"));
  for (std::size_t i = 0; i < word.events.size(); ++i) {
    from_wire(sieve, wire.events()[i], word.events[i]);
  }
  return sieve.flaw();
}

}  // namespace tacit
