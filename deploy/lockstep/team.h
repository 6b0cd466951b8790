#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "idl/types/event.h"
#include "idl/types/policy_text.h"
#include "robot_agent/brain/brain.h"
#include "world_server/world/world.h"

namespace tacit {

/// The parts of a team's tick, in order; the last four are the world's.
enum class TeamPhase : std::uint8_t { Between, Decisions, Intent, Motion, Rules, Sensing };
inline constexpr std::size_t kTeamPhases = 6;

/// A whole team and its world in one process, without DDS: the two functions called in turn.
///
/// The same scenario and seed give the same events here and over DDS, bit for bit.
class Team {
 public:
  /// One brain per robot of `world`. Throws ConfigError when either configuration cannot be.
  Team(const WorldConfig& world, const BrainConfig& brain, std::uint64_t seed);

  /// Begins the run with what earlier ones taught: `policies[i]` to robot i+1. Call before the
  /// first step. Throws ConfigError when one is not for its robot.
  void inherit(std::span<const PolicyText> policies);
  /// What each robot has learned; robot i+1 at index i.
  [[nodiscard]] std::vector<std::string> policies() const;

  [[nodiscard]] Tick tick() const { return world_.tick(); }
  /// Whether the run is over at its last tick, or before because the mission is.
  [[nodiscard]] bool done(Tick last_tick) const { return tick() >= last_tick || world_.over(); }
  [[nodiscard]] const World& world() const { return world_; }
  [[nodiscard]] std::span<const Brain> brains() const { return brains_; }

  /// Lets every brain decide and the world move on by one tick; not when the mission is over.
  /// Returns what happened, valid until the next call.
  std::span<const Event> step();

  /// Calls `observer` at the end of every phase of every tick from now on, so that somebody with a
  /// clock can tell where the time goes; an empty one stops it. `Between` ends when a step begins.
  /// This team must stay where it is meanwhile.
  void on_phase(std::function<void(TeamPhase)> observer);

  /// The event that closes the log of a complete run.
  [[nodiscard]] Event ending() const { return {tick(), RunEnded{world_.digest()}}; }

 private:
  World world_;
  std::vector<Brain> brains_;
  std::vector<Command> commands_;
  std::function<void(TeamPhase)> observer_;
};

}  // namespace tacit
