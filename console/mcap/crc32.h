#pragma once

#include <boost/crc.hpp>
#include <cstdint>

#include "console/mcap/bytes.h"

namespace tacit::mcap {

/// The checksum of MCAP and of zlib, of bytes that come piece by piece.
class Crc32 {
 public:
  void add(Span bytes) { crc_.process_bytes(bytes.data(), bytes.size()); }
  [[nodiscard]] std::uint32_t value() const { return crc_.checksum(); }

 private:
  boost::crc_32_type crc_;
};

[[nodiscard]] inline std::uint32_t crc32(Span bytes) {
  Crc32 crc;
  crc.add(bytes);
  return crc.value();
}

}  // namespace tacit::mcap
