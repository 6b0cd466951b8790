#pragma once

#include <cstdint>
#include <string>
#include <variant>

#include "idl/types/frames.h"
#include "idl/types/ids.h"
#include "idl/types/percept.h"
#include "idl/types/word.h"

namespace tacit {

enum class EnemyKind : std::uint8_t {
  Normal,  ///< Attacks the target.
  Decoy,   ///< Draws robots away from it.
  Hunter,  ///< Disables robots.
};

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

/// An enemy is back in its hiding place outside the area.
struct EnemyRetreated {
  EnemyId enemy;
  friend bool operator==(const EnemyRetreated&, const EnemyRetreated&) = default;
};

struct MineTaken {
  RobotId robot;
  MineId mine;
  friend bool operator==(const MineTaken&, const MineTaken&) = default;
};

/// A mine was put down outside the base.
struct MineDropped {
  RobotId robot;
  MineId mine;
  WorldVec position_m;
  friend bool operator==(const MineDropped&, const MineDropped&) = default;
};

/// A mine was dropped at the base; `left` others are still to be stored.
struct MineStored {
  RobotId robot;
  MineId mine;
  std::uint32_t left = 0;
  friend bool operator==(const MineStored&, const MineStored&) = default;
};

/// Why a robot can do nothing more until a teammate helps it.
enum class Mishap : std::uint8_t {
  Mud,    ///< The terrain.
  Enemy,  ///< A hunter's touch.
};

struct RobotDisabled {
  RobotId robot;
  Mishap by = Mishap::Mud;
  friend bool operator==(const RobotDisabled&, const RobotDisabled&) = default;
};

struct RobotRevived {
  RobotId robot;
  RobotId by;
  friend bool operator==(const RobotRevived&, const RobotRevived&) = default;
};

/// The first event of a forage run.
struct ForageBegun {
  std::uint32_t mines = 0;  ///< To be stored.
  friend bool operator==(const ForageBegun&, const ForageBegun&) = default;
};

/// How a mission that has an end came to it.
enum class Verdict : std::uint8_t {
  Accomplished,  ///< The last mine is stored.
  TeamLost,      ///< Every robot is disabled, so nobody is left to help.
  OutOfTime,     ///< The cap was reached.
};

/// The mission is over. `score_ticks` is the tick of the last mine's storage, or the cap when the
/// mission failed.
struct MissionOver {
  Verdict verdict = Verdict::Accomplished;
  Tick score_ticks = 0;
  friend bool operator==(const MissionOver&, const MissionOver&) = default;
};

/// The first event of an operation.
struct OperationBegun {
  std::uint32_t team = 0;    ///< Robots that carry out the mission.
  std::uint32_t extras = 0;  ///< Robots beside them: sentries, pedestrians.
  friend bool operator==(const OperationBegun&, const OperationBegun&) = default;
};

struct ObjectTaken {
  RobotId robot;
  ObjectId object;
  friend bool operator==(const ObjectTaken&, const ObjectTaken&) = default;
};

/// An object was put down outside every container.
struct ObjectDropped {
  RobotId robot;
  ObjectId object;
  WorldVec position_m;
  friend bool operator==(const ObjectDropped&, const ObjectDropped&) = default;
};

/// An object was put into a container, for good.
struct ObjectStored {
  RobotId robot;
  ObjectId object;
  ObjectId container;
  friend bool operator==(const ObjectStored&, const ObjectStored&) = default;
};

struct ObjectTested {
  RobotId robot;
  ObjectId object;
  Finding finding = Finding::Harmless;
  friend bool operator==(const ObjectTested&, const ObjectTested&) = default;
};

/// A doorway, numbered from 1 in the map's order, has got a mark or lost it.
struct DoorwayMarked {
  RobotId robot;
  std::uint32_t doorway = 0;
  bool marked = true;
  friend bool operator==(const DoorwayMarked&, const DoorwayMarked&) = default;
};

/// A robot is in another room or hallway than before, or in the open; also said where it starts.
struct SiteEntered {
  RobotId robot;
  Site site = Site::Open;
  std::uint32_t number = 0;  ///< Of the room or hallway, from 1 in the map's order; 0 in the open.
  friend bool operator==(const SiteEntered&, const SiteEntered&) = default;
};

/// A robot is at a point of the map, numbered from 1 in the map's order, for the first time.
struct PointReached {
  RobotId robot;
  std::uint32_t point = 0;
  friend bool operator==(const PointReached&, const PointReached&) = default;
};

/// A robot said something aloud, and so many others heard it.
struct Signalled {
  RobotId robot;
  Word word;
  std::uint32_t heard = 0;
  friend bool operator==(const Signalled&, const Signalled&) = default;
};

/// A robot told its operator something.
struct Alerted {
  RobotId robot;
  Word word;
  friend bool operator==(const Alerted&, const Alerted&) = default;
};

/// A robot of the team has come into, or gone out of, the sight of an extra robot.
struct RobotExposed {
  RobotId robot;
  RobotId to;
  bool exposed = true;
  friend bool operator==(const RobotExposed&, const RobotExposed&) = default;
};

/// A robot has nothing more to do.
struct RobotFinished {
  RobotId robot;
  friend bool operator==(const RobotFinished&, const RobotFinished&) = default;
};

/// What an operator can tell a robot.
enum class OperatorAct : std::uint8_t {
  Steer,  ///< The joystick is held this way.
  LetGo,  ///< It is let go.
  Proceed,
  SkipGoal,
};

struct OperatorActed {
  RobotId robot;
  OperatorAct act = OperatorAct::Proceed;
  WorldVec joystick{};  ///< Steer: where to, length 0 to 1.
  friend bool operator==(const OperatorActed&, const OperatorActed&) = default;
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
  double mean_distance_to_target_m = 0.0;  ///< Over the robots; in a forage mission, to the base.
  double mean_speed_mps = 0.0;             ///< Over the robots.
  friend bool operator==(const Checkpoint&, const Checkpoint&) = default;
};

/// The last event of a complete run.
struct RunEnded {
  std::uint64_t state_digest = 0;
  friend bool operator==(const RunEnded&, const RunEnded&) = default;
};

using Happening =
    std::variant<EnemyCreated, EnemyIntercepted, TargetHit, Collision, RobotLost, RobotBack,
                 RobotLate, Checkpoint, RunEnded, EnemyRetreated, MineTaken, MineDropped,
                 MineStored, RobotDisabled, RobotRevived, MissionOver, ForageBegun, OperationBegun,
                 ObjectTaken, ObjectDropped, ObjectStored, ObjectTested, DoorwayMarked, SiteEntered,
                 PointReached, Signalled, Alerted, RobotExposed, RobotFinished, OperatorActed>;

struct Event {
  Tick tick = 0;
  Happening what;
  friend bool operator==(const Event&, const Event&) = default;
};

/// One line of the event log: a JSON object without the newline. Numbers are printed in the
/// shortest form that reads back to the same bits.
[[nodiscard]] std::string to_line(const Event& event);

/// "normal", "decoy", "hunter".
[[nodiscard]] const char* name(EnemyKind kind);
/// "obstacle", "wall", "robot", "enemy".
[[nodiscard]] const char* name(Obstruction obstruction);
/// "harmless", "dangerous"; "none" for no finding.
[[nodiscard]] const char* name(Finding finding);
/// "open", "room", "hallway".
[[nodiscard]] const char* name(Site site);
/// "steer", "let_go", "proceed", "skip_goal".
[[nodiscard]] const char* name(OperatorAct act);
/// "mud", "enemy".
[[nodiscard]] const char* name(Mishap mishap);
/// "accomplished", "team_lost", "out_of_time".
[[nodiscard]] const char* name(Verdict verdict);

}  // namespace tacit
