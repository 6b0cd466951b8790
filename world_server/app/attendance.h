#pragma once

#include <vector>

#include "idl/types/event.h"
#include "world_server/app/agent_port.h"
#include "world_server/app/process_watch.h"
#include "world_server/app/roster.h"

namespace tacit {

/// Who takes part: lets agents in, and notices who has gone and who is back.
///
/// A robot is present from the look at which its agent, once welcome, is connected to the look at
/// which its process has ended or its connection broken.
class Attendance {
 public:
  /// `port` outlives this.
  Attendance(const Admission& admission, AgentPort& port);

  /// Looks, so that an agent that was started again finds its forerunner's seat free, and answers
  /// with an order. Returns what changed.
  [[nodiscard]] std::vector<Happening> hear(const Hello& hello);
  /// What changed since the last look: `RobotLost`, `RobotBack`.
  [[nodiscard]] std::vector<Happening> look();

  /// Robot i+1 at index i.
  [[nodiscard]] const std::vector<bool>& present() const { return present_; }
  [[nodiscard]] std::size_t count() const;
  [[nodiscard]] bool complete() const { return count() == present_.size(); }
  /// "2, 5": the robots that are not present.
  [[nodiscard]] std::string absent() const;

 private:
  [[nodiscard]] bool has_gone(std::size_t index) const;
  void dismiss(std::size_t index);

  AgentPort& port_;
  Roster roster_;
  ProcessWatch watch_;
  std::vector<bool> present_;
};

}  // namespace tacit
