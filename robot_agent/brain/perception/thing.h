#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace tacit {

/// The classes of things that schemas and triggers can be about. On a map an object's colour tells
/// its class.
enum class Thing : std::uint8_t {
  Mine,
  Base,  ///< Where a forager stores mines; seen or remembered.
  Enemy,
  Disabled,     ///< A teammate painted as disabled.
  Friend,       ///< An able teammate.
  Flag,         ///< Purple.
  EodArea,      ///< Green: where explosive ordnance is put.
  Rock,         ///< Black.
  Tree,         ///< Sea green.
  Home,         ///< White: home base or start place; seen or remembered.
  Unknown,      ///< Brown: what may be dangerous.
  UnknownHere,  ///< The same, not seen through a doorway: in the room that the robot is in.
  HidingPlace,  ///< Light blue; also a hostage.
};

/// In the order of the enumerators.
inline constexpr std::array<std::string_view, 13> kThingNames{
    "Mine", "Base", "Enemy", "Disabled", "Friend",      "Flag",       "EodArea",
    "Rock", "Tree", "Home",  "Unknown",  "UnknownHere", "HidingPlace"};
inline constexpr std::size_t kThings = kThingNames.size();

[[nodiscard]] constexpr std::string_view name(Thing thing) {
  return kThingNames[static_cast<std::size_t>(thing)];
}

/// One or more classes of things.
class ThingSet {
 public:
  constexpr ThingSet() = default;
  // NOLINTNEXTLINE(google-explicit-constructor): one thing is a set of one
  constexpr ThingSet(Thing thing) : bits_(1U << static_cast<unsigned>(thing)) {}

  [[nodiscard]] constexpr bool empty() const { return bits_ == 0; }
  [[nodiscard]] constexpr bool has(Thing thing) const {
    return (bits_ & ThingSet(thing).bits_) != 0;
  }
  [[nodiscard]] constexpr ThingSet operator|(ThingSet other) const {
    ThingSet both;
    both.bits_ = bits_ | other.bits_;
    return both;
  }
  /// Calls `visit(index)` for each, in the order of the enumerators.
  template <class Visit>
  constexpr void for_each(Visit&& visit) const {
    for (unsigned rest = bits_; rest != 0; rest &= rest - 1) {
      visit(static_cast<std::size_t>(std::countr_zero(rest)));
    }
  }
  friend constexpr bool operator==(ThingSet, ThingSet) = default;

 private:
  std::uint32_t bits_ = 0;
};

/// "Mine", "MineOrFlag".
[[nodiscard]] inline std::string name(ThingSet things) {
  std::string text;
  things.for_each([&text](std::size_t index) {
    text.append(text.empty() ? "" : "Or").append(kThingNames[index]);
  });
  return text;
}

}  // namespace tacit
