#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace tacit {

/// The classes of things that schemas and triggers can be about.
enum class Thing : std::uint8_t {
  Mine,
  Base,  ///< Seen or remembered.
  Enemy,
  Disabled,  ///< A teammate painted as disabled.
};

/// In the order of the enumerators.
inline constexpr std::array<std::string_view, 4> kThingNames{"Mine", "Base", "Enemy", "Disabled"};
inline constexpr std::size_t kThings = kThingNames.size();

[[nodiscard]] constexpr std::string_view name(Thing thing) {
  return kThingNames[static_cast<std::size_t>(thing)];
}

}  // namespace tacit
