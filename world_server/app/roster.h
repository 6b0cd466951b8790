#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "idl/types/roster.h"

namespace tacit {

/// What an agent must bring along to be let in.
struct Admission {
  std::size_t robots = 1;       ///< In the scenario, numbered from 1.
  std::string version;          ///< Of the world server's program.
  std::string scenario_digest;  ///< Of the world server's scenario.
};

/// Which agent process speaks for which robot.
class Roster {
 public:
  explicit Roster(Admission admission);

  /// Seats the agent or says why not. The same agent may say hello again.
  [[nodiscard]] Order admit(const Hello& hello);
  /// Frees the robot's seat.
  void dismiss(RobotId robot);
  /// Who has the robot's seat.
  [[nodiscard]] const std::optional<Hello>& agent_of(RobotId robot) const;

 private:
  [[nodiscard]] std::string reason_to_refuse(const Hello& hello) const;

  Admission admission_;
  std::vector<std::optional<Hello>> seats_;
};

}  // namespace tacit
