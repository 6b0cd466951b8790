#include "idl/bus/cdr.h"

#include <exception>

#include "idl/bus/convert_events.h"
#include "idl/bus/convert_team.h"
#include "idl/bus/convert_views.h"
#include "idl/bus/wire_of.h"
#include "idl/wire/teamPubSubTypes.h"

namespace tacit {
namespace {

using eprosima::fastrtps::rtps::SerializedPayload_t;

constexpr Flaw kUndecodable{"it cannot be decoded"};

/// To make one costs more than to use it.
template <class Support>
Support& support() {
  thread_local Support made;
  return made;
}

/// A payload of somebody else's memory.
class Lent {
 public:
  explicit Lent(std::vector<std::uint8_t>& bytes) {
    payload.data = bytes.data();
    payload.length = static_cast<std::uint32_t>(bytes.size());
    payload.max_size = payload.length;
  }
  ~Lent() { payload.data = nullptr; }
  Lent(const Lent&) = delete;
  Lent& operator=(const Lent&) = delete;

  SerializedPayload_t payload;
};

/// What Fast DDS does with a payload: false also for whatever Fast CDR throws.
template <class Support, class Wire>
bool decoded(std::span<const std::uint8_t> bytes, Wire& wire) {
  // Fast CDR reads the payload's bytes alone, but wants them as its own.
  std::vector<std::uint8_t> copy(bytes.begin(), bytes.end());
  Lent lent(copy);
  try {
    return support<Support>().deserialize(&lent.payload, &wire);
  } catch (const std::exception&) {
    return false;
  }
}

}  // namespace

template <class Word>
void to_cdr(const Word& word, std::vector<std::uint8_t>& bytes) {
  typename WireOf<Word>::Wire wire;
  to_wire(word, wire);
  auto& type = support<typename WireOf<Word>::Support>();
  // Fast CDR steps over the gaps before aligned members.
  bytes.assign(type.getSerializedSizeProvider(&wire)(), 0);
  Lent lent(bytes);
  type.serialize(&wire, &lent.payload);
  bytes.resize(lent.payload.length);
}

template <class Word>
Flaw from_cdr(std::span<const std::uint8_t> bytes, Word& word) {
  typename WireOf<Word>::Wire wire;
  if (!decoded<typename WireOf<Word>::Support>(bytes, wire)) return kUndecodable;
  return from_wire(wire, word);
}

template void to_cdr(const EventBatch&, std::vector<std::uint8_t>&);
template void to_cdr(const RunStatus&, std::vector<std::uint8_t>&);
template void to_cdr(const Telemetry&, std::vector<std::uint8_t>&);
template void to_cdr(const WorldView&, std::vector<std::uint8_t>&);
template Flaw from_cdr(std::span<const std::uint8_t>, EventBatch&);
template Flaw from_cdr(std::span<const std::uint8_t>, RunStatus&);
template Flaw from_cdr(std::span<const std::uint8_t>, Telemetry&);
template Flaw from_cdr(std::span<const std::uint8_t>, WorldView&);

}  // namespace tacit
