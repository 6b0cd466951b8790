#include "world_server/world/missions/operator_desk.h"

#include <utility>

namespace tacit {
namespace {

bool is_operators(ControlKind kind) {
  switch (kind) {
    case ControlKind::Steer:
    case ControlKind::LetGo:
    case ControlKind::Proceed:
    case ControlKind::SkipGoal:
      return true;
    case ControlKind::Pause:
    case ControlKind::Resume:
    case ControlKind::Step:
    case ControlKind::Speed:
    case ControlKind::Stop:
      return false;
  }
  return false;
}

}  // namespace

OperatorDesk::OperatorDesk(Proceed proceed, std::size_t team, std::size_t robots)
    : proceed_(proceed), team_(team), stations_(robots) {}

bool OperatorDesk::hear(const Control& control) {
  if (!is_operators(control.kind) || control.robot.value > stations_.size()) {
    return false;
  }
  if (control.robot.value != 0) {
    hear(control, stations_[control.robot.value - 1u]);
    return true;
  }
  for (std::size_t i = 0; i < team_; ++i) {
    hear(control, stations_[i]);
  }
  return true;
}

void OperatorDesk::hear(const Control& control, Station& station) {
  if (control.kind == ControlKind::Proceed) {
    station.next_proceed = true;
  } else if (control.kind == ControlKind::SkipGoal) {
    station.next_skip_goal = true;
  } else {
    const bool held = control.kind == ControlKind::Steer;
    station.stick_moved = true;
    station.next_stick = held ? std::optional(clipped(control.joystick, 1.0)) : std::nullopt;
  }
}

void OperatorDesk::serve(Stage& stage) {
  for (std::size_t i = 0; i < stations_.size(); ++i) {
    serve(stage.id_of(i), stations_[i], stage);
  }
}

void OperatorDesk::serve(RobotId robot, Station& station, Stage& stage) {
  if (std::exchange(station.stick_moved, false) && station.stick != station.next_stick) {
    station.stick = station.next_stick;
    const OperatorAct act = station.stick ? OperatorAct::Steer : OperatorAct::LetGo;
    stage.report(OperatorActed{robot, act, station.stick.value_or(WorldVec{})});
  }
  station.proceed = std::exchange(station.next_proceed, false);
  station.skip_goal = std::exchange(station.next_skip_goal, false);
  if (station.proceed) {
    stage.report(OperatorActed{robot, OperatorAct::Proceed});
  }
  if (station.skip_goal) {
    stage.report(OperatorActed{robot, OperatorAct::SkipGoal});
  }
}

OperatorInput OperatorDesk::input(std::size_t robot, const Heading& heading) const {
  const Station& station = stations_[robot];
  return {station.stick.has_value(), to_body(heading, station.stick.value_or(WorldVec{})),
          proceed_ == Proceed::AtOnce || station.proceed, station.skip_goal};
}

void OperatorDesk::add_to(Digest& digest) const {
  for (const Station& station : stations_) {
    const WorldVec stick = station.stick.value_or(WorldVec{});
    digest.add(static_cast<std::uint64_t>(station.stick.has_value()));
    digest.add(stick.x());
    digest.add(stick.y());
    digest.add(static_cast<std::uint64_t>(station.proceed));
    digest.add(static_cast<std::uint64_t>(station.skip_goal));
  }
}

}  // namespace tacit
