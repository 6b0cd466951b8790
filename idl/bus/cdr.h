#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "idl/bus/sieve.h"

namespace tacit {

/// The bytes that a word is on the bus: XCDR1, little-endian, with the 4 bytes before it that say
/// so. For EventBatch, RunStatus, Telemetry and WorldView. `bytes` is overwritten.
template <class Word>
void to_cdr(const Word& word, std::vector<std::uint8_t>& bytes);

/// The word that such bytes are. The flaw of bytes that are none, or of a word that no sound sender
/// sends; `word` then has no meaning.
template <class Word>
[[nodiscard]] Flaw from_cdr(std::span<const std::uint8_t> bytes, Word& word);

}  // namespace tacit
