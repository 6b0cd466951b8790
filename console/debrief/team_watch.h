#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include "idl/types/event.h"

namespace tacit {

/// What robots of MissionLab's pair say to each other.
inline constexpr std::string_view kCoverMe = "Cover me.";
inline constexpr std::string_view kEnemyFound = "Enemy found.";
inline constexpr std::string_view kHallwayClear = "Hallway clear.";

/// The robot that the others of its team cover.
inline constexpr RobotId kFirstRobot{1};

/// Where a robot is.
struct Whereabouts {
  Site site = Site::Open;
  std::uint32_t number = 0;  ///< As in SiteEntered.
};

/// Where the robots of the team are, and whether they have been warned.
class TeamWatch {
 public:
  /// The robots 1 to `team`.
  explicit TeamWatch(std::size_t team) : where_(team) {}

  void add(const Event& event);

  [[nodiscard]] std::size_t team() const { return where_.size(); }
  [[nodiscard]] bool in_team(RobotId robot) const {
    return robot.value >= 1 && robot.value <= where_.size();
  }
  /// `in_team(robot)`.
  [[nodiscard]] const Whereabouts& where(RobotId robot) const {
    return where_.at(robot.value - 1U);
  }
  /// Somebody of the team has said "Enemy found." and nobody "Hallway clear." since.
  [[nodiscard]] bool alarm() const { return alarm_; }
  /// Whether `said` is that word from a robot of the team.
  [[nodiscard]] bool is_call(const Signalled& said, std::string_view word) const {
    return in_team(said.robot) && said.word.text() == word;
  }

 private:
  std::vector<Whereabouts> where_;  ///< By robot.
  bool alarm_ = false;
};

}  // namespace tacit
