#pragma once

#include <cstdint>
#include <string>

#include "idl/types/event.h"
#include "idl/wire/team.h"

namespace tacit {

/// Writes the member values of one happening.
class EventWriter {
 public:
  explicit EventWriter(wire::Event& out) : out_(out) {}

  void operator()(const EnemyCreated& e) {
    out_.number(e.enemy.value);
    out_.detail(static_cast<std::uint8_t>(e.kind));
    out_.x_m(e.position_m.x());
    out_.y_m(e.position_m.y());
  }
  void operator()(const EnemyIntercepted& e) {
    out_.number(e.enemy.value);
    out_.detail(static_cast<std::uint8_t>(e.kind));
    out_.robot(e.robot.value);
    out_.distance_to_target_m(e.distance_to_target_m);
  }
  void operator()(const TargetHit& e) {
    out_.number(e.enemy.value);
    out_.distance_to_target_m(e.distance_to_target_m);
  }
  void operator()(const Collision& e) {
    out_.robot(e.robot.value);
    out_.detail(static_cast<std::uint8_t>(e.with));
    out_.number(e.other);
  }
  void operator()(const RobotLost& e) { out_.robot(e.robot.value); }
  void operator()(const RobotBack& e) { out_.robot(e.robot.value); }
  void operator()(const RobotLate& e) { out_.robot(e.robot.value); }
  void operator()(const Checkpoint& e) {
    out_.state_digest(e.state_digest);
    out_.number(e.enemies);
    out_.mean_distance_to_target_m(e.mean_distance_to_target_m);
    out_.mean_speed_mps(e.mean_speed_mps);
  }
  void operator()(const RunEnded& e) { out_.state_digest(e.state_digest); }
  void operator()(const EnemyRetreated& e) { out_.number(e.enemy.value); }
  void operator()(const MineTaken& e) { mine(e.robot, e.mine); }
  void operator()(const MineDropped& e) {
    mine(e.robot, e.mine);
    out_.x_m(e.position_m.x());
    out_.y_m(e.position_m.y());
  }
  void operator()(const MineStored& e) {
    mine(e.robot, e.mine);
    out_.left(e.left);
  }
  void operator()(const RobotDisabled& e) {
    out_.robot(e.robot.value);
    out_.detail(static_cast<std::uint8_t>(e.by));
  }
  void operator()(const RobotRevived& e) {
    out_.robot(e.robot.value);
    out_.other_robot(e.by.value);
  }
  void operator()(const MissionOver& e) {
    out_.detail(static_cast<std::uint8_t>(e.verdict));
    out_.score_ticks(e.score_ticks);
  }
  void operator()(const ForageBegun& e) { out_.left(e.mines); }
  void operator()(const OperationBegun& e) {
    out_.number(e.team);
    out_.other(e.extras);
  }
  void operator()(const ObjectTaken& e) { numbered(e.robot, e.object.value); }
  void operator()(const ObjectDropped& e) {
    numbered(e.robot, e.object.value);
    out_.x_m(e.position_m.x());
    out_.y_m(e.position_m.y());
  }
  void operator()(const ObjectStored& e) {
    numbered(e.robot, e.object.value);
    out_.other(e.container.value);
  }
  void operator()(const ObjectTested& e) {
    numbered(e.robot, e.object.value);
    out_.detail(static_cast<std::uint8_t>(e.finding));
  }
  void operator()(const DoorwayMarked& e) {
    numbered(e.robot, e.doorway);
    out_.detail(e.marked ? 1 : 0);
  }
  void operator()(const SiteEntered& e) {
    numbered(e.robot, e.number);
    out_.detail(static_cast<std::uint8_t>(e.site));
  }
  void operator()(const PointReached& e) { numbered(e.robot, e.point); }
  void operator()(const Signalled& e) {
    said(e.robot, e.word);
    out_.other(e.heard);
  }
  void operator()(const Alerted& e) { said(e.robot, e.word); }
  void operator()(const RobotExposed& e) {
    out_.robot(e.robot.value);
    out_.other_robot(e.to.value);
    out_.detail(e.exposed ? 1 : 0);
  }
  void operator()(const RobotFinished& e) { out_.robot(e.robot.value); }
  void operator()(const OperatorActed& e) {
    out_.robot(e.robot.value);
    out_.detail(static_cast<std::uint8_t>(e.act));
    out_.joystick_x(e.joystick.x());
    out_.joystick_y(e.joystick.y());
  }

 private:
  void numbered(RobotId robot, std::uint32_t number) {
    out_.robot(robot.value);
    out_.number(number);
  }
  void said(RobotId robot, const Word& word) {
    out_.robot(robot.value);
    out_.word(std::string(word.text()));
  }
  void mine(RobotId robot, MineId mine) {
    out_.robot(robot.value);
    out_.number(mine.value);
  }

  wire::Event& out_;
};

}  // namespace tacit
