#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <span>

#include "idl/types/command.h"
#include "idl/types/event.h"
#include "idl/types/percept.h"
#include "idl/types/roster.h"
#include "idl/types/world_view.h"
#include "world_server/world/world_config.h"

namespace tacit {

/// The parts of a step, in order.
enum class WorldPhase : std::uint8_t {
  Intent,   ///< Commands and enemies' wishes become velocities; enemies come in.
  Motion,   ///< Bodies move and touch.
  Rules,    ///< What the mission makes of it; the tick counts.
  Sensing,  ///< Percepts of the new tick.
};

/// The world: a function from commands to percepts and events.
///
/// Pure: no clock, no thread, no file, no communication. Two worlds with the same configuration,
/// seed and commands have the same history, bit for bit.
class World {
 public:
  /// Throws ConfigError when the scenario cannot be placed (obstacles that do not fit, a map with
  /// errors, …).
  World(const WorldConfig& config, std::uint64_t seed);
  ~World();
  World(World&&) noexcept;
  World& operator=(World&&) noexcept;

  /// The tick whose percepts stand ready; 0 at first.
  [[nodiscard]] Tick tick() const;

  /// What each robot senses now, in order of id: robot i at index i-1. Valid until the next step.
  [[nodiscard]] std::span<const Percept> percepts() const;

  /// One tick on; not when the mission is over. `commands` holds at most one command per robot, in
  /// any order; a robot without one stands still. Returns what happened, valid until the next step.
  std::span<const Event> step(std::span<const Command> commands);

  /// What an operator tells one robot or all of the team: to be done in the next step, whose events
  /// and percepts show it. False, and nothing done, when it is no operator's word, when there is no
  /// such robot, or when the mission has no operator.
  bool operate(const Control& control);

  /// Whether the mission has come to its end, as its last event said; a guard has none.
  [[nodiscard]] bool over() const;

  /// A digest of every body's state.
  [[nodiscard]] std::uint64_t digest() const;

  void view(WorldView& out) const;

  /// Calls `observer` at the end of every phase of every step from now on, so that somebody with a
  /// clock can tell where the time goes; an empty one stops it. It must not touch the world.
  void on_phase(std::function<void(WorldPhase)> observer);

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace tacit
