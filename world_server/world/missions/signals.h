#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "idl/types/word.h"
#include "world_server/world/missions/mission.h"
#include "world_server/world/sensing/line_of_sight.h"

namespace tacit {

/// What robots say aloud in one step, and who hears it: every other robot in range, unless a wall
/// is in between where that matters, it misses the signal by chance, or it has heard as much as a
/// percept holds. Who speaks is served in order of id.
class Signals {
 public:
  Signals(const SignalConfig& config, std::uint64_t seed, std::size_t robots);

  /// Lets those who signal in this step be heard. `sight` is turned on the way.
  void spread(Stage& stage, LineOfSight& sight);
  /// What `robot` heard in the last step.
  [[nodiscard]] std::span<const Word> heard(std::size_t robot) const { return heard_[robot]; }

 private:
  void say(std::size_t speaker, Stage& stage, const LineOfSight& sight);
  [[nodiscard]] bool reaches(const WorldVec& offset, const LineOfSight& sight) const;
  /// Whether `hearer` misses what `speaker` says at `tick`; depends on nothing else.
  [[nodiscard]] bool misses(std::size_t hearer, std::size_t speaker, Tick tick) const;

  SignalConfig config_;
  std::uint64_t seed_;
  std::vector<std::vector<Word>> heard_;  ///< Per robot.
};

}  // namespace tacit
