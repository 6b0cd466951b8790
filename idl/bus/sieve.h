#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace tacit {

/// Why a sample from the wire was refused; empty when it is sound.
struct Flaw {
  std::string_view what;
  [[nodiscard]] explicit operator bool() const { return !what.empty(); }
};

/// Lets sound values through and remembers the first that is not.
///
/// Each check returns the value, or a harmless one in its place, so that a conversion reads as a
/// list of members; `what` must outlive the sieve (a literal).
class Sieve {
 public:
  /// Refuses NaN and what lies outside [low, high].
  double number(double value, double low, double high, std::string_view what) {
    return pass(value >= low && value <= high, what) ? value : 0.0;
  }
  template <class Count>
  std::size_t count(Count value, std::size_t limit, std::string_view what) {
    return pass(value <= limit, what) ? static_cast<std::size_t>(value) : 0;
  }
  /// A code of `Enum`, whose last value is `last`.
  template <class Enum>
  Enum code(std::uint8_t value, Enum last, std::string_view what) {
    const bool known = pass(value <= static_cast<std::uint8_t>(last), what);
    return static_cast<Enum>(known ? value : 0);
  }
  bool flag(std::uint8_t value, std::string_view what) { return pass(value <= 1, what) && value; }
  template <class Whole>
  Whole whole(Whole value, Whole low, Whole high, std::string_view what) {
    return pass(value >= low && value <= high, what) ? value : low;
  }
  /// Writes at most `limit` characters into `out`.
  template <class Text>
  void text(const Text& value, std::size_t limit, std::string& out, std::string_view what) {
    out.assign(value.c_str(), pass(value.size() <= limit, what) ? value.size() : 0);
  }
  bool pass(bool sound, std::string_view what) {
    if (!sound && !flaw_) flaw_.what = what;
    return sound;
  }

  [[nodiscard]] Flaw flaw() const { return flaw_; }

 private:
  Flaw flaw_;
};

/// The numbers that any scenario stays within. What lies outside is no measurement.
namespace limits {
inline constexpr double kPositionM = 1e6;
inline constexpr double kOdometryM = 1e9;
inline constexpr double kSpeedMps = 1e4;
inline constexpr double kTurnRadps = 1e4;
inline constexpr double kRadiusM = 1e4;
inline constexpr double kPush = 1e9;
inline constexpr double kWallS = 1e9;
inline constexpr double kSimulatedS = 1e12;
inline constexpr double kSpeedFactor = 1e6;
inline constexpr std::uint64_t kTick = (std::uint64_t{1} << 63) - 1;
}  // namespace limits

}  // namespace tacit
