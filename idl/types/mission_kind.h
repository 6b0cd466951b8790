#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace tacit {

/// What a team is there for; decides which parameters a scenario has.
enum class MissionKind : std::uint8_t {
  Guard,      ///< Keep enemies from a target (paper, section 2).
  Forage,     ///< Bring mines to a storage area, under hazards and a hunter (paper, section 3).
  Operation,  ///< Whatever a mission file says, on a map (paper, section 4).
};

/// As a scenario names them, in the order of the enumerators.
inline constexpr std::array<std::string_view, 3> kMissionNames{"guard", "forage", "operation"};

[[nodiscard]] constexpr std::string_view name(MissionKind kind) {
  return kMissionNames[static_cast<std::size_t>(kind)];
}

/// The mission called `text`; Guard when there is none of that name.
[[nodiscard]] constexpr MissionKind mission_kind(std::string_view text) {
  for (std::size_t i = 0; i < kMissionNames.size(); ++i) {
    if (kMissionNames[i] == text) return static_cast<MissionKind>(i);
  }
  return MissionKind::Guard;
}

}  // namespace tacit
