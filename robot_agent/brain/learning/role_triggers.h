#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "robot_agent/brain/perception/surroundings.h"
#include "robot_agent/brain/roles/role.h"

namespace tacit {

/// One of the Boolean triggers that make the perceptual state of a team member (paper, section 3).
struct RoleTrigger {
  std::string_view name;
  std::optional<std::size_t> implies;  ///< The trigger without which this one cannot be.
};
// clang-format off
inline constexpr std::array<RoleTrigger, 4> kRoleTriggers{{
    {"DetectEnemy", std::nullopt},  // An enemy is visible.
    {"IsInvasion",  0},             // One within 5 m is.
    {"DetectDead",  std::nullopt},  // A disabled robot is visible.
    {"IsDieOff",    2},             // One within 5 m is.
}};
// clang-format on

/// Which triggers are true; bit i is that of `kRoleTriggers[i]`.
struct TriggerSet {
  std::uint8_t bits = 0;

  [[nodiscard]] bool has(std::size_t trigger) const { return (bits >> trigger & 1U) != 0; }
  friend bool operator==(TriggerSet, TriggerSet) = default;
};
inline constexpr std::size_t kTriggerSets = std::size_t{1} << kRoleTriggers.size();

/// How near is "within 5 m".
struct TriggerRanges {
  double invasion_m = 5.0;
  double die_off_m = 5.0;
};

[[nodiscard]] TriggerSet role_triggers(const Surroundings& around, const TriggerRanges& ranges);

/// Whether no trigger is true without the one that it implies.
[[nodiscard]] bool feasible(TriggerSet triggers);

/// The names of the true ones, joined by "+"; empty when there are none.
[[nodiscard]] std::string words(TriggerSet triggers);
/// The inverse of `words`; empty for any other text.
[[nodiscard]] std::optional<TriggerSet> triggers_in(std::string_view words);

/// The learner's internal states: what is perceived, and the role played (48, as in the paper).
inline constexpr std::size_t kInternalStates = kTriggerSets * kRoles;

[[nodiscard]] constexpr std::size_t internal_state(TriggerSet triggers, Role role) {
  return index(role) + kRoles * triggers.bits;
}
[[nodiscard]] constexpr Role role_in(std::size_t internal_state) {
  return static_cast<Role>(internal_state % kRoles);
}
[[nodiscard]] constexpr TriggerSet triggers_in(std::size_t internal_state) {
  return {static_cast<std::uint8_t>(internal_state / kRoles)};
}

}  // namespace tacit
