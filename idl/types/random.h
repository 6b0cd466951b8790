#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace tacit {

/// What the generator takes in and gives out at once.
using PhiloxBlock = std::array<std::uint32_t, 4>;

/// Philox 4x32-10 (Salmon et al. 2011): a block of chance for every counter and key. The key's
/// low half is the generator's first key word.
[[nodiscard]] PhiloxBlock philox(PhiloxBlock counter, std::uint64_t key);

/// A stream of chance, named by what it is for.
///
/// Counter-based (Philox 4x32-10; Salmon et al. 2011): the n-th draw is a function of (seed,
/// purpose, owner, n) alone, so one more user of chance disturbs no other, and a stream can be
/// continued anywhere by its `position`.
class Stream {
 public:
  /// `purpose` names the use ("obstacle field", "enemy wander"); `owner` is the robot or enemy it
  /// belongs to, 0 for the world's own.
  Stream(std::uint64_t seed, std::string_view purpose, std::uint64_t owner = 0);

  [[nodiscard]] std::uint64_t bits();
  /// In [0, 1), 53 bits.
  [[nodiscard]] double uniform();
  /// In [low, high).
  [[nodiscard]] double uniform(double low, double high);
  /// In [0, count); count > 0.
  [[nodiscard]] std::uint64_t below(std::uint64_t count);
  /// Standard normal (Box-Muller).
  [[nodiscard]] double normal();

  [[nodiscard]] std::uint64_t position() const { return position_; }
  void seek(std::uint64_t position) { position_ = position; }

 private:
  std::uint64_t key_;
  std::uint64_t owner_;
  std::uint64_t position_ = 0;
};

}  // namespace tacit
