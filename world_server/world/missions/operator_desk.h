#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "world_server/world/missions/mission.h"

namespace tacit {

/// What an operator does at a control station, robot by robot.
///
/// Words come in at any time and count from the next step on; of those that say the same, the last
/// one. A joystick is held until it is let go; the words to go on and to leave out a goal last one
/// tick.
class OperatorDesk {
 public:
  /// Gives the word to go on in every tick?
  enum class Proceed : std::uint8_t { AtOnce, Ask };

  /// The first `team` of `robots` robots are the team.
  OperatorDesk(Proceed proceed, std::size_t team, std::size_t robots);

  /// False when it is no operator's word, or for nobody.
  bool hear(const Control& control);
  /// Does what came in, and says so.
  void serve(Stage& stage);
  /// What a robot that faces `heading` has of it.
  [[nodiscard]] OperatorInput input(std::size_t robot, const Heading& heading) const;
  void add_to(Digest& digest) const;

 private:
  /// Of one robot.
  struct Station {
    std::optional<WorldVec> stick;
    bool proceed = false;
    bool skip_goal = false;
    // What came in since the last step.
    bool stick_moved = false;
    std::optional<WorldVec> next_stick;
    bool next_proceed = false;
    bool next_skip_goal = false;
  };
  static void hear(const Control& control, Station& station);
  static void serve(RobotId robot, Station& station, Stage& stage);

  Proceed proceed_;
  std::size_t team_;
  std::vector<Station> stations_;
};

}  // namespace tacit
