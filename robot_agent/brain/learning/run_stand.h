#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "robot_agent/brain/fsa/entry.h"
#include "robot_agent/brain/learning/q_learner.h"
#include "robot_agent/brain/perception/forage_perception.h"

namespace tacit {

/// Where a forager's brain stands in the middle of a run, what it has learned apart.
struct RunStand {
  std::string learner;
  std::string role;                      ///< Empty before the first decision.
  std::string state;                     ///< Of the role's automaton.
  Entry entered;                         ///< When and where that state was.
  bool disabled = false;                 ///< In the last tick.
  std::optional<QLearner::Choice> last;  ///< Of a Q-learner, as are the next three.
  Tick last_tick = 0;                    ///< When that was chosen.
  std::uint64_t triggers = 0;            ///< In the last tick in which it was able.
  std::uint64_t chance = 0;              ///< Position of its stream of exploration.
  ForagePerception::Memory perception;
};

/// A JSON object in one line; `parse_stand` reads it back to the same bits.
[[nodiscard]] std::string to_line(const RunStand& stand);

}  // namespace tacit
