#pragma once

#include <cstddef>
#include <vector>

#include "idl/types/frames.h"
#include "idl/types/ids.h"

namespace tacit {

/// What a vision system can call a thing.
enum class Kind : std::uint8_t { Target, Teammate, Enemy, Mine, Base };

/// How it is painted. Red is an enemy, blue a working robot, yellow a disabled one, white the
/// target, orange a mine, purple the base (the storage area for mines).
enum class Colour : std::uint8_t { White, Blue, Red, Yellow, Orange, Purple };

/// Something recognised within range, field of view and line of sight. Carries no identity.
struct Sighting {
  Kind kind = Kind::Target;
  Colour colour = Colour::White;
  BodyVec offset_m;       ///< From the robot's centre to the thing's centre, body frame.
  double radius_m = 0.0;  ///< Apparent radius of the thing, >= 0.
};

/// A surface that a range finder returned: a round obstacle, or with radius 0 the nearest point
/// of a wall.
struct SeenObstacle {
  BodyVec offset_m;       ///< From the robot's centre to the obstacle's centre, body frame.
  double radius_m = 0.0;  ///< >= 0.
};

/// What a robot has brought about in the last step, as it notices by itself. What that is worth is
/// not for the world to say.
struct Deeds {
  bool picked_up = false;    ///< It took a mine up.
  bool stored = false;       ///< It dropped a mine at the base.
  bool dropped = false;      ///< It put a mine down elsewhere, or lost it when it was disabled.
  bool intercepted = false;  ///< It destroyed an enemy.
  bool revived = false;      ///< It got a disabled teammate going again.
  friend bool operator==(const Deeds&, const Deeds&) = default;
};

/// All that a robot senses in one tick, and all that its brain may know.
///
/// The order of the lists carries no meaning. What a sensor cannot hold is dropped, farthest
/// first (`kMaxSightings`, `kMaxObstacles`).
struct Percept {
  static constexpr std::size_t kMaxSightings = 128;
  static constexpr std::size_t kMaxObstacles = 64;

  RobotId robot;
  Tick tick = 0;
  OdometryPose odometry;  ///< Own dead reckoning since tick 0.
  BodyVec velocity_mps;   ///< Own velocity over ground.
  bool touching = false;  ///< A bumper was pressed during the last step.
  bool able = true;       ///< False while it is disabled: stuck, yellow, deaf to commands.
  bool holding = false;   ///< It carries a mine.
  Deeds deeds;
  std::vector<Sighting> sightings;
  std::vector<SeenObstacle> obstacles;
};

}  // namespace tacit
