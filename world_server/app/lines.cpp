#include "world_server/app/lines.h"

namespace tacit {
namespace {

/// A robot's topic carries that robot's commands and no other's.
Subscriber<topics::Command>::Take into(Barrier& barrier, Participant& participant, RobotId robot) {
  return [&barrier, &participant, robot](Command& command) {
    if (command.robot != robot || barrier.put(command) == Arrival::Stranger) {
      participant.rejections().add(topic_name<topics::Command>(robot),
                                   {"it is of another robot than its topic"});
    }
  };
}

}  // namespace

Lines::Lines(Participant& participant, std::size_t robots, Barrier& barrier)
    : participant_(participant) {
  lines_.reserve(robots);
  for (std::size_t i = 0; i < robots; ++i) {
    const RobotId robot{static_cast<std::uint16_t>(i + 1)};
    lines_.push_back(
        {Publisher<topics::Percept>(participant, robot),
         Publisher<topics::Order>(participant, robot),
         Subscriber<topics::Command>(participant, robot, into(barrier, participant, robot))});
  }
}

void Lines::send(const Percept& percept) { line_of(percept.robot).percepts.publish(percept); }

void Lines::send(const Order& order) {
  if (static_cast<std::size_t>(order.robot.value) > lines_.size()) {
    send_to_stranger(order);
  } else {
    line_of(order.robot).orders.publish(order);
  }
}

bool Lines::connected(RobotId robot) const {
  const Line& line = lines_.at(static_cast<std::size_t>(robot.value) - 1);
  return line.percepts.readers() > 0 && line.commands.writers() > 0;
}

void Lines::forget(RobotId robot) {
  line_of(robot).percepts = Publisher<topics::Percept>(participant_, robot, Promise::Answer);
}

void Lines::flush(std::chrono::milliseconds patience) {
  const auto until = Bell::Clock::now() + patience;
  for (Line& line : lines_) {
    const auto left =
        std::chrono::duration_cast<std::chrono::milliseconds>(until - Bell::Clock::now());
    if (left.count() <= 0 || !line.orders.wait_received(left)) return;
  }
}

Lines::Line& Lines::line_of(RobotId robot) {
  return lines_.at(static_cast<std::size_t>(robot.value) - 1);
}

void Lines::send_to_stranger(const Order& order) {
  auto known = strangers_.find(order.robot);
  if (known == strangers_.end()) {
    if (strangers_.size() == kMaxStrangers) return;
    known =
        strangers_.emplace(order.robot, Publisher<topics::Order>(participant_, order.robot)).first;
  }
  known->second.publish(order);
}

}  // namespace tacit
