#pragma once

#include <compare>
#include <cstdint>

namespace tacit {

/// One control cycle of the team. Tick 0 is the first percept, before anything has moved.
using Tick = std::uint64_t;

/// A robot of the team, numbered from 1 in every scenario, log and topic name.
struct RobotId {
  std::uint16_t value = 0;
  friend auto operator<=>(const RobotId&, const RobotId&) = default;
};

/// An enemy, numbered from 1 in order of creation and never reused within a run.
struct EnemyId {
  std::uint32_t value = 0;
  friend auto operator<=>(const EnemyId&, const EnemyId&) = default;
};

/// A mine, numbered from 1 in the order in which they were laid.
struct MineId {
  std::uint32_t value = 0;
  friend auto operator<=>(const MineId&, const MineId&) = default;
};

/// An object of the map, numbered from 1 in the map's order.
struct ObjectId {
  std::uint32_t value = 0;
  friend auto operator<=>(const ObjectId&, const ObjectId&) = default;
};

}  // namespace tacit
