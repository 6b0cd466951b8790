#pragma once

#include <map>
#include <vector>

#include "idl/bus/publisher.h"
#include "idl/bus/subscriber.h"
#include "world_server/app/agent_port.h"
#include "world_server/app/barrier.h"

namespace tacit {

/// The topics between the world server and each robot of the scenario.
class Lines final : public AgentPort {
 public:
  /// Commands go into `barrier`, which outlives this, as does `participant`.
  Lines(Participant& participant, std::size_t robots, Barrier& barrier);

  void send(const Percept& percept) override;
  void send(const Order& order) override;
  [[nodiscard]] bool connected(RobotId robot) const override;
  /// From now on this robot's percepts do not go through memory that is shared with its agent: one
  /// that was killed may have left its lock behind.
  void forget(RobotId robot) override;

  /// Waits until the orders so far have reached the agents that are there, or `patience` is over.
  void flush(std::chrono::milliseconds patience);

 private:
  struct Line {
    Publisher<topics::Percept> percepts;
    Publisher<topics::Order> orders;
    Subscriber<topics::Command> commands;
  };

  /// Of robots that are not in the scenario: more than this many get no answer.
  static constexpr std::size_t kMaxStrangers = 32;

  [[nodiscard]] Line& line_of(RobotId robot);
  void send_to_stranger(const Order& order);

  Participant& participant_;
  std::vector<Line> lines_;
  std::map<RobotId, Publisher<topics::Order>> strangers_;
};

}  // namespace tacit
