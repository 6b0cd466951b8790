#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "idl/types/event.h"
#include "robot_agent/brain/brain.h"
#include "world_server/world/world.h"

namespace tacit {

/// A whole team and its world in one process, without DDS: the two functions called in turn.
///
/// The same scenario and seed give the same events here and over DDS, bit for bit.
class Team {
 public:
  /// One brain per robot of `world`. Throws ConfigError when either configuration cannot be.
  Team(const WorldConfig& world, const BrainConfig& brain, std::uint64_t seed);

  [[nodiscard]] Tick tick() const { return world_.tick(); }
  [[nodiscard]] const World& world() const { return world_; }
  [[nodiscard]] std::span<const Brain> brains() const { return brains_; }

  /// Lets every brain decide and the world move on by one tick. Returns what happened, valid
  /// until the next call.
  std::span<const Event> step();

  /// The event that closes the log of a complete run.
  [[nodiscard]] Event ending() const { return {tick(), RunEnded{world_.digest()}}; }

 private:
  World world_;
  std::vector<Brain> brains_;
  std::vector<Command> commands_;
};

}  // namespace tacit
