#pragma once

#include "idl/types/percept.h"
#include "idl/types/roster.h"

namespace tacit {

/// How words reach the agents. Percepts may get lost, doubled or late; orders arrive.
class AgentPort {
 public:
  virtual ~AgentPort() = default;
  virtual void send(const Percept& percept) = 0;
  virtual void send(const Order& order) = 0;
  /// Whether percepts and commands can pass between the world and this robot's agent.
  [[nodiscard]] virtual bool connected(RobotId robot) const = 0;
  /// This robot's agent is gone, and what it held when it went is not to be waited for. Not while
  /// a percept is being sent.
  virtual void forget(RobotId robot) = 0;
};

}  // namespace tacit
