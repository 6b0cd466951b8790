#pragma once

#include <cstdint>
#include <string>
#include <variant>

#include "idl/types/frames.h"
#include "idl/types/ids.h"

namespace tacit {

enum class EnemyKind : std::uint8_t { Normal, Decoy };

/// What a body can bump into.
enum class Obstruction : std::uint8_t { Obstacle, Wall, Robot, Enemy };

struct EnemyCreated {
  EnemyId enemy;
  EnemyKind kind = EnemyKind::Normal;
  WorldVec position_m;
  friend bool operator==(const EnemyCreated&, const EnemyCreated&) = default;
};

/// A robot reached an enemy and destroyed it.
struct EnemyIntercepted {
  EnemyId enemy;
  EnemyKind kind = EnemyKind::Normal;
  RobotId robot;
  double distance_to_target_m = 0.0;
  friend bool operator==(const EnemyIntercepted&, const EnemyIntercepted&) = default;
};

/// An enemy reached the target and destroyed itself; the target survives.
struct TargetHit {
  EnemyId enemy;
  double distance_to_target_m = 0.0;
  friend bool operator==(const TargetHit&, const TargetHit&) = default;
};

/// A robot began to touch something in this step.
struct Collision {
  RobotId robot;
  Obstruction with = Obstruction::Obstacle;
  std::uint32_t other = 0;  ///< Obstacle or wall number, robot id or enemy id.
  friend bool operator==(const Collision&, const Collision&) = default;
};

/// A robot's agent is gone; the robot stands still until it is back.
struct RobotLost {
  RobotId robot;
  friend bool operator==(const RobotLost&, const RobotLost&) = default;
};

struct RobotBack {
  RobotId robot;
  friend bool operator==(const RobotBack&, const RobotBack&) = default;
};

/// A robot's command missed its tick; the robot stood still for it.
struct RobotLate {
  RobotId robot;
  friend bool operator==(const RobotLate&, const RobotLate&) = default;
};

/// How the team stands, every so many ticks. The digest covers every body's state, so that two
/// runs that part can be told where.
struct Checkpoint {
  std::uint64_t state_digest = 0;
  std::uint32_t enemies = 0;               ///< Alive, decoys included.
  double mean_distance_to_target_m = 0.0;  ///< Over the robots.
  double mean_speed_mps = 0.0;             ///< Over the robots.
  friend bool operator==(const Checkpoint&, const Checkpoint&) = default;
};

/// The last event of a complete run.
struct RunEnded {
  std::uint64_t state_digest = 0;
  friend bool operator==(const RunEnded&, const RunEnded&) = default;
};

using Happening = std::variant<EnemyCreated, EnemyIntercepted, TargetHit, Collision, RobotLost,
                               RobotBack, RobotLate, Checkpoint, RunEnded>;

struct Event {
  Tick tick = 0;
  Happening what;
  friend bool operator==(const Event&, const Event&) = default;
};

/// One line of the event log: a JSON object without the newline. Numbers are printed in the
/// shortest form that reads back to the same bits.
[[nodiscard]] std::string to_line(const Event& event);

/// "normal", "decoy".
[[nodiscard]] const char* name(EnemyKind kind);
/// "obstacle", "wall", "robot", "enemy".
[[nodiscard]] const char* name(Obstruction obstruction);

}  // namespace tacit
