#pragma once

#include <algorithm>
#include <span>
#include <string_view>

#include "robot_agent/brain/perception/surroundings.h"

namespace tacit {

/// Fires while a signal rings in the robot's ears.
struct Notified {
  static constexpr std::string_view kName = "Notified";
  Word word;

  [[nodiscard]] bool holds(const Surroundings& around) const {
    return around.premises.has_heard(word.text());
  }
};

/// Fires when the robot has given its signal.
struct MessageSent {
  static constexpr std::string_view kName = "MessageSent";

  [[nodiscard]] bool holds(const Surroundings& around) const { return around.deeds.signalled; }
};

/// Fires when the robot has alerted its operator.
struct Alerted {
  static constexpr std::string_view kName = "Alerted";

  [[nodiscard]] bool holds(const Surroundings& around) const { return around.deeds.alerted; }
};

/// Fires while the behaviour of its state says that its task is done, with this word.
struct TaskExited {
  static constexpr std::string_view kName = "TaskExited";
  Word word;

  [[nodiscard]] bool holds(const Surroundings& /*around*/, std::span<const Word> exit) const {
    return std::find(exit.begin(), exit.end(), word) != exit.end();
  }
};

}  // namespace tacit
