#include "idl/bus/identity.h"

#include <bit>

namespace tacit {
namespace {

std::uint8_t byte(std::uint32_t value, int shift) {
  return static_cast<std::uint8_t>((value >> shift) & 0xffU);
}

}  // namespace

GuidPrefix guid_prefix(const Identity& identity) {
  const std::uint32_t nonce = identity.run_nonce;
  const std::uint32_t incarnation = identity.incarnation;
  const auto party =
      static_cast<std::uint32_t>(std::bit_width(static_cast<unsigned>(identity.party)));
  const std::uint32_t role = party << 12 | (incarnation & 0xfffU);
  return {0x01,
          0x0f,
          byte(nonce, 24),
          byte(nonce, 16),
          byte(identity.robot.value, 8),
          byte(identity.robot.value, 0),
          byte(role, 8),
          byte(role, 0),
          byte(nonce, 8),
          byte(nonce, 0),
          byte(incarnation, 20),
          byte(incarnation, 12)};
}

bool of_run(const GuidPrefix& prefix, std::uint32_t run_nonce) {
  return prefix[0] == 0x01 && prefix[1] == 0x0f && prefix[2] == byte(run_nonce, 24) &&
         prefix[3] == byte(run_nonce, 16) && prefix[8] == byte(run_nonce, 8) &&
         prefix[9] == byte(run_nonce, 0);
}

std::uint16_t discovery_port(int domain) {
  return static_cast<std::uint16_t>(7400 + 250 * domain + 5);
}

}  // namespace tacit
