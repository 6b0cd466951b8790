#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "idl/bus/identity.h"

namespace tacit {
namespace {

constexpr std::uint32_t kNonce = 0x12345678;

GuidPrefix prefix(Party party, std::uint16_t robot, std::uint32_t incarnation) {
  return guid_prefix({party, {robot}, 1, kNonce, incarnation});
}

TEST(GuidPrefix, DiffersWithinItsFirstEightBytesBetweenTheProcessesOfARun) {
  std::set<std::array<std::uint8_t, 8>> seen;
  int count = 0;
  const auto add = [&](const GuidPrefix& p) {
    std::array<std::uint8_t, 8> front{};
    std::copy_n(p.begin(), 8, front.begin());
    seen.insert(front);
    ++count;
  };
  add(prefix(Party::World, 0, 0));
  add(prefix(Party::Console, 0, 0));
  add(prefix(Party::Launcher, 0, 0));
  for (std::uint16_t robot = 1; robot <= 300; ++robot) add(prefix(Party::Agent, robot, 7));
  add(prefix(Party::Agent, 1, 8));
  EXPECT_EQ(static_cast<int>(seen.size()), count);
}

TEST(GuidPrefix, BelongsToItsRun) { EXPECT_TRUE(of_run(prefix(Party::Agent, 5, 99), kNonce)); }

TEST(GuidPrefix, BelongsToNoOtherRun) {
  for (int bit = 0; bit < 32; ++bit) {
    EXPECT_FALSE(of_run(prefix(Party::Agent, 5, 99), kNonce ^ (1U << bit))) << bit;
  }
}

TEST(GuidPrefix, OfAnotherVendorBelongsToNoRun) {
  GuidPrefix other = prefix(Party::Agent, 5, 99);
  other[1] = 0x10;
  EXPECT_FALSE(of_run(other, kNonce));
}

TEST(DiscoveryPort, DiffersBetweenDomainsAndLiesBelowTheEphemeralPorts) {
  EXPECT_NE(discovery_port(1), discovery_port(2));
  EXPECT_LT(discovery_port(100), 32768);
}

}  // namespace
}  // namespace tacit
