#pragma once

#include "robot_agent/brain/perception/place_memory.h"
#include "robot_agent/brain/perception/surroundings.h"

namespace tacit {

/// Turns a forager's percepts into surroundings. Allocates nothing once it has seen the largest
/// percept.
class ForagePerception {
 public:
  /// What outlives a tick.
  struct Memory {
    std::optional<OdometryVec> base_m;
    QuarryTrack::Record track;
  };

  /// Able teammates from `teammate_reach_m` outwards are left out.
  ForagePerception(double teammate_reach_m, const QuarryTrack::Config& track);

  /// Call once per tick, ticks ascending. The result borrows from `percept` and from this.
  [[nodiscard]] const Surroundings& look(const Percept& percept);

  [[nodiscard]] Memory memory() const { return {base_.place_m(), track_.record()}; }
  /// Whether the memory is one of this configuration.
  [[nodiscard]] bool fits(const Memory& memory) const { return track_.fits(memory.track); }
  /// Goes on from a memory that fits.
  void resume(const Memory& memory);

 private:
  void sort(const Percept& percept);
  void follow_enemy();

  double squared_reach_m2_;
  PlaceMemory base_;
  QuarryTrack track_;
  Surroundings around_;
};

}  // namespace tacit
