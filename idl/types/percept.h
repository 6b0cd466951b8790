#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "idl/types/frames.h"
#include "idl/types/ids.h"
#include "idl/types/word.h"

namespace tacit {

/// What a vision system can call a thing. An object is told by its colour alone.
enum class Kind : std::uint8_t { Target, Teammate, Enemy, Mine, Base, Object };

/// How it is painted. Red is an enemy, blue a working robot, yellow a disabled one, white the
/// target or a home or start place, orange a mine, purple the base (the storage area for mines) or
/// a flag, green an area for explosive ordnance, black a rock, sea green a tree, brown something
/// unknown that may be dangerous, light blue a hiding place or hostage (MissionLab); grey is an
/// object that has been tested [ours].
enum class Colour : std::uint8_t {
  White,
  Blue,
  Red,
  Yellow,
  Orange,
  Purple,
  Green,
  Black,
  SeaGreen,
  Brown,
  LightBlue,
  Grey,
};

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

/// What the walls around make of the place where a robot is.
enum class Site : std::uint8_t { Open, Room, Hallway };

/// A doorway in line of sight.
struct SeenDoorway {
  BodyVec offset_m;     ///< From the robot's centre to the middle of the opening.
  BodyVec jamb_m;       ///< From there to one of its jambs: half the opening.
  bool marked = false;  ///< Somebody has put a mark on it.
};

/// The hallway that a robot is in, as it lies along its centre line.
struct SeenHallway {
  BodyVec offset_m;       ///< From the robot's centre to the nearest point of the centre line.
  BodyVec along;          ///< The line's direction there, length 1; one of the two.
  double ahead_m = 0.0;   ///< From that point to the line's end that way, >= 0.
  double behind_m = 0.0;  ///< To its other end.
  double width_m = 0.0;
};

/// What a test says of an object.
enum class Finding : std::uint8_t { None, Harmless, Dangerous };

/// What a robot's operator does at its control station in this tick.
struct OperatorInput {
  bool teleoperated = false;  ///< The joystick is in hand.
  BodyVec joystick;           ///< Length 0 to 1, turned into the robot's frame.
  bool proceed = false;       ///< The word to go on.
  bool skip_goal = false;     ///< The word to leave out the goal under way.
};

/// What a robot has brought about in the last step, as it notices by itself. What that is worth is
/// not for the world to say.
struct Deeds {
  bool picked_up = false;    ///< It took a mine or an object up.
  bool stored = false;       ///< It dropped it at the base or in a container.
  bool dropped = false;      ///< It put a mine down elsewhere, or lost it when it was disabled.
  bool intercepted = false;  ///< It destroyed an enemy.
  bool revived = false;      ///< It got a disabled teammate going again.
  bool marked = false;       ///< It put a mark on a doorway, or took it off.
  bool signalled = false;    ///< It gave a signal.
  bool alerted = false;      ///< It alerted its operator.
  Finding tested = Finding::None;
  friend bool operator==(const Deeds&, const Deeds&) = default;
};

/// All that a robot senses in one tick, and all that its brain may know.
///
/// The order of the lists carries no meaning. What a sensor cannot hold is dropped, farthest
/// first (`kMaxSightings`, `kMaxObstacles`).
struct Percept {
  static constexpr std::size_t kMaxSightings = 128;
  static constexpr std::size_t kMaxObstacles = 64;
  static constexpr std::size_t kMaxDoorways = 16;
  static constexpr std::size_t kMaxHeard = 4;

  RobotId robot;
  Tick tick = 0;
  OdometryPose odometry;         ///< Own dead reckoning since tick 0.
  BodyVec velocity_mps;          ///< Own velocity over ground.
  bool touching = false;         ///< A bumper was pressed during the last step.
  bool able = true;              ///< False while it is disabled: stuck, yellow, deaf to commands.
  bool holding = false;          ///< It carries a mine or an object.
  Colour held = Colour::Orange;  ///< Of what it carries.
  Deeds deeds;
  std::vector<Sighting> sightings;
  std::vector<SeenObstacle> obstacles;

  // On a map with rooms and hallways.
  Site site = Site::Open;
  std::optional<SeenHallway> hallway;  ///< In a hallway.
  std::vector<SeenDoorway> doorways;
  // From other robots and from the operator.
  std::vector<Word> heard;  ///< Signals given in the last step, by whomever.
  OperatorInput operated;
};

}  // namespace tacit
