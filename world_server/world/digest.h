#pragma once

#include <bit>
#include <cstdint>

namespace tacit {

/// Folds numbers into 64 bits so that any change of any of them, or of their order, shows.
class Digest {
 public:
  void add(std::uint64_t value) {
    // SplitMix64's finaliser (Steele, Lea, Flood 2014).
    std::uint64_t z = state_ + value + 0x9E3779B97F4A7C15;
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EB;
    state_ = z ^ (z >> 31);
  }
  void add(double value) { add(std::bit_cast<std::uint64_t>(value)); }
  [[nodiscard]] std::uint64_t value() const { return state_; }

 private:
  std::uint64_t state_ = 0;
};

}  // namespace tacit
