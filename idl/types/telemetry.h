#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "idl/types/frames.h"
#include "idl/types/ids.h"

namespace tacit {

/// One motor schema's share in a decision.
struct SchemaShare {
  std::string name;   ///< "MoveToTarget", …; at most 31 characters.
  double gain = 0.0;  ///< Weight in the sum.
  BodyVec push;       ///< The schema's own output before weighting, body frame.
};

/// What went on in a brain at one tick, for people and recordings; no robot reads it.
struct Telemetry {
  static constexpr std::size_t kMaxShares = 16;
  static constexpr std::size_t kMaxName = 31;  ///< Letters in each of the names.

  RobotId robot;
  Tick tick = 0;
  std::string learner;    ///< "static1", "static2", "lm"; at most 31 characters.
  std::string situation;  ///< "AllClear", …; empty when the learner has none.
  std::string role;       ///< "Forager", …; empty when the brain has no roles.
  std::string state;      ///< Of the role's automaton, "MoveToMine", …; empty when it has none.
  std::vector<SchemaShare> shares;
  std::uint64_t decisions = 0;   ///< Since the process started.
  std::uint64_t duplicates = 0;  ///< Percepts of a tick that had been answered already.
  std::uint64_t rejected = 0;    ///< Samples that `convert` refused.
};

}  // namespace tacit
