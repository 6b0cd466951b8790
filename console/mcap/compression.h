#pragma once

#include <string_view>

#include "console/mcap/bytes.h"

namespace tacit::mcap {

/// The largest chunk that is read; whoever claims more means harm. [ours]
inline constexpr std::uint64_t kMostChunkBytes = std::uint64_t{256} << 20;

/// With zstd, into `out`, which is overwritten.
void compress(Span bytes, Bytes& out);

/// `how` is "zstd", or empty for bytes as they are. Throws std::runtime_error when they are not
/// compressed in this way, hold another number of bytes than `size`, or more than
/// `kMostChunkBytes`.
[[nodiscard]] Bytes decompressed(Span bytes, std::string_view how, std::uint64_t size);

}  // namespace tacit::mcap
