#pragma once

#include <cstdint>
#include <vector>

#include "idl/types/random.h"

namespace tacit {

/// Mud pits that nobody sees: every robot gets stuck with the same chance in each tick in which it
/// is able, whatever the others do (paper, section 3: "a random occurrence for each robot").
///
/// The number of able ticks up to the next mishap is drawn ahead, from the geometric distribution
/// that such ticks have.
class Mud {
 public:
  Mud(double per_tick, std::uint64_t seed, std::size_t robots);

  /// One more tick of `robot`, which is able: whether it gets stuck in it.
  [[nodiscard]] bool sticks(std::size_t robot) {
    if (--left_[robot] != 0) {
      return false;
    }
    left_[robot] = wait(robot);
    return true;
  }

 private:
  [[nodiscard]] std::uint64_t wait(std::size_t robot);

  double log_free_;  ///< Logarithm of the chance not to get stuck in a tick.
  bool always_;
  std::vector<Stream> chances_;
  std::vector<std::uint64_t> left_;  ///< Able ticks up to the mishap, which is in the last.
};

}  // namespace tacit
