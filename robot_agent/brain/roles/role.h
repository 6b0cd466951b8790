#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

namespace tacit {

/// What a robot of a foraging team can be (paper, section 3).
enum class Role : std::uint8_t {
  Forager,   ///< Brings mines to the base.
  Soldier,   ///< Intercepts enemies.
  Mechanic,  ///< Gets disabled teammates going again.
};

/// The paper's names, in the order of the enumerators.
inline constexpr std::array<std::string_view, 3> kRoleNames{"Forager", "Soldier", "Mechanic"};
inline constexpr std::size_t kRoles = kRoleNames.size();

[[nodiscard]] constexpr std::size_t index(Role role) { return static_cast<std::size_t>(role); }

[[nodiscard]] constexpr std::string_view name(Role role) { return kRoleNames[index(role)]; }

/// The role called `text`; empty when there is none.
[[nodiscard]] constexpr std::optional<Role> role_called(std::string_view text) {
  const auto found = std::find(kRoleNames.begin(), kRoleNames.end(), text);
  if (found == kRoleNames.end()) return std::nullopt;
  return static_cast<Role>(found - kRoleNames.begin());
}

}  // namespace tacit
