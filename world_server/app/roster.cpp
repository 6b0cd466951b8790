#include "world_server/app/roster.h"

namespace tacit {
namespace {

std::size_t index_of(RobotId robot) { return static_cast<std::size_t>(robot.value) - 1; }

std::string number(RobotId robot) { return std::to_string(robot.value); }

}  // namespace

Roster::Roster(Admission admission) : admission_(std::move(admission)), seats_(admission_.robots) {}

Order Roster::admit(const Hello& hello) {
  Order order{hello.robot, hello.incarnation, OrderKind::Welcome, reason_to_refuse(hello)};
  if (order.reason.empty()) {
    seats_[index_of(hello.robot)] = hello;
  } else {
    order.kind = OrderKind::Refuse;
  }
  return order;
}

void Roster::dismiss(RobotId robot) { seats_.at(index_of(robot)).reset(); }

const std::optional<Hello>& Roster::agent_of(RobotId robot) const {
  return seats_.at(index_of(robot));
}

std::string Roster::reason_to_refuse(const Hello& hello) const {
  if (index_of(hello.robot) >= seats_.size()) {
    return "robot " + number(hello.robot) + " is not in the scenario, which has robots 1 to " +
           std::to_string(seats_.size());
  }
  if (hello.version != admission_.version) {
    return "the agent is of version " + hello.version + ", wanted " + admission_.version;
  }
  if (hello.scenario_digest != admission_.scenario_digest) {
    return "the agent read another scenario (SHA-256 " + hello.scenario_digest + "), wanted " +
           admission_.scenario_digest;
  }
  const std::optional<Hello>& seated = agent_of(hello.robot);
  if (seated && seated->incarnation != hello.incarnation) {
    return "robot " + number(hello.robot) + " has an agent already: process " +
           std::to_string(seated->pid) + " on " + seated->host;
  }
  return {};
}

}  // namespace tacit
