#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "idl/types/percept.h"

namespace tacit {

/// A doorway into a room.
struct Entrance {
  OdometryVec middle_m;
  OdometryVec inwards;  ///< Across the doorway into the room, length 1.
};

/// Where a robot of an operation is and what it has been told, made ready for thinking.
struct Premises {
  /// By dead reckoning from where it was told that it starts.
  WorldPose pose;
  Site site = Site::Open;
  std::optional<SeenHallway> hallway;
  std::span<const SeenDoorway> doorways;
  /// The way along a hallway that it last faced, length 1; kept when it leaves the hallway.
  std::optional<OdometryVec> course;
  /// The doorway through which it last came into a room.
  std::optional<Entrance> entrance;
  std::vector<SeenObstacle> friends;  ///< Teammates in sight, working or not.
  std::vector<SeenObstacle> enemies;
  /// What it has heard of late, each once.
  std::vector<Word> heard;
  OperatorInput operated;
  Colour held = Colour::Orange;  ///< Of what it carries, while it carries something.
  /// Where it was at each of the last ticks, the present one first.
  std::span<const OdometryVec> track;

  [[nodiscard]] bool has_heard(std::string_view word) const {
    for (const Word& each : heard) {
      if (each.text() == word) return true;
    }
    return false;
  }
};

}  // namespace tacit
