#include "world_server/world/missions/mud.h"

#include <cmath>

#include "idl/types/elementary.h"

namespace tacit {
namespace {

// More ticks than any run has.
constexpr double kForever = 1e18;

}  // namespace

Mud::Mud(double per_tick, std::uint64_t seed, std::size_t robots)
    : log_free_(per_tick < 1.0 ? natural_log(1.0 - per_tick) : 0.0), always_(per_tick >= 1.0) {
  for (std::size_t robot = 0; robot < robots; ++robot) {
    chances_.emplace_back(seed, "mud", robot + 1);
    left_.push_back(wait(robot));
  }
}

// Free of n ticks in a row with the chance exp(n log_free): the first n for which that falls to a
// uniform draw or below.
std::uint64_t Mud::wait(std::size_t robot) {
  if (always_) {
    return 1;
  }
  const double free = 1.0 - chances_[robot].uniform();
  const double ticks = log_free_ < 0.0 ? std::floor(natural_log(free) / log_free_) : kForever;
  return 1 + static_cast<std::uint64_t>(ticks < kForever ? ticks : kForever);
}

}  // namespace tacit
