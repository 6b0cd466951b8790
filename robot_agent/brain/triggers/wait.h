#pragma once

#include <string_view>

#include "robot_agent/brain/fsa/entry.h"
#include "robot_agent/brain/perception/surroundings.h"

namespace tacit {

/// Fires from `ticks` after its state was entered.
struct Wait {
  static constexpr std::string_view kName = "Wait";
  Tick ticks = 0;
  Tick since = 0;  ///< When the state was entered.

  void entered(const Entry& entry) { since = entry.tick; }
  [[nodiscard]] bool holds(const Surroundings& around) const {
    return around.tick >= since + ticks;
  }
};

}  // namespace tacit
