#pragma once

#include <array>
#include <cstdint>

#include "idl/topics/topics.h"
#include "idl/types/ids.h"

namespace tacit {

/// Who takes part in the traffic of one run, or in the wizard's.
struct Identity {
  Party party = Party::Agent;
  RobotId robot;                  ///< Of an agent; of a client more of its incarnation; else 0.
  int domain = 1;                 ///< Of this run; see DomainLease.
  std::uint32_t run_nonce = 0;    ///< Tells runs apart; the same in all processes of one.
  std::uint32_t incarnation = 0;  ///< Tells processes with the same role apart; 0 for the world.
};

/// The 12 bytes that name a participant on the wire, made from its identity.
///
/// Bytes 0 and 1 are the vendor's. Bytes 2, 3, 8 and 9 hold the nonce, so that what a killed
/// process of a run left in shared memory can be told by its name. Bytes 4 to 7 hold robot, party
/// and a part of the incarnation: Fast DDS takes participants for one process when bytes 0 to 7
/// agree.
using GuidPrefix = std::array<std::uint8_t, 12>;
[[nodiscard]] GuidPrefix guid_prefix(const Identity& identity);

/// True for the prefixes of all participants of the run.
[[nodiscard]] bool of_run(const GuidPrefix& prefix, std::uint32_t run_nonce);

/// The domain on which a wizard is looked for, one that no run gets.
inline constexpr int kWizardDomain = 101;
/// All wizards' and their clients'.
inline constexpr std::uint32_t kWizardNonce = 0x7ac17;

/// The UDP port on 127.0.0.1 at which the world server or the wizard of `domain` answers; no port
/// that the standard hands out itself.
[[nodiscard]] std::uint16_t discovery_port(int domain);

}  // namespace tacit
