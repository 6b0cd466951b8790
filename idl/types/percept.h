#pragma once

#include <cstddef>
#include <vector>

#include "idl/types/frames.h"
#include "idl/types/ids.h"

namespace tacit {

/// What a vision system can call a thing.
enum class Kind : std::uint8_t { Target, Teammate, Enemy };

/// How it is painted. Red is an enemy, blue a working robot, yellow a disabled one, white the
/// target.
enum class Colour : std::uint8_t { White, Blue, Red, Yellow };

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
  std::vector<Sighting> sightings;
  std::vector<SeenObstacle> obstacles;
};

}  // namespace tacit
