#pragma once

#include <string_view>

#include "robot_agent/brain/perception/surroundings.h"

namespace tacit {

/// Fires when a test has found something dangerous.
struct TestPositive {
  static constexpr std::string_view kName = "TestPositive";

  [[nodiscard]] bool holds(const Surroundings& around) const {
    return around.deeds.tested == Finding::Dangerous;
  }
};

/// Fires when a test has found something harmless.
struct TestNegative {
  static constexpr std::string_view kName = "TestNegative";

  [[nodiscard]] bool holds(const Surroundings& around) const {
    return around.deeds.tested == Finding::Harmless;
  }
};

}  // namespace tacit
