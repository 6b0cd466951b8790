#pragma once

#include <cstdint>
#include <string_view>

#include "idl/types/parameters.h"
#include "robot_agent/brain/perception/occlusion.h"
#include "robot_agent/brain/perception/surroundings.h"

namespace tacit {

/// The five situations that a soldier tells apart (paper, section 2).
enum class Situation : std::uint8_t {
  AllClear,            ///< There are no visible enemies.
  ClearToEnemy,        ///< Between the target and the nearest group that nobody occludes.
  FlankingEnemy,       ///< Nobody occludes that group, but the soldier is not between.
  SoldierNeedsHelp,    ///< Every group is intercepted, at least one by too few.
  NoSoldiersNeedHelp,  ///< Every group is intercepted by enough.
};

struct SituationConfig {
  double between_lateral_m = 6.0;
  double overwhelmed_ratio = 0.5;  ///< The paper's T.
};

[[nodiscard]] Situation situation(const Surroundings& around, const Occlusion& occlusion,
                                  const SituationConfig& config);

/// Whether this robot is between `target_m` and `group_m`: its projection lies on the segment that
/// joins them, and it is no farther than `lateral_m` from it. False when the two coincide.
[[nodiscard]] bool between(const BodyVec& target_m, const BodyVec& group_m, double lateral_m);

/// Whether `interceptors` are too few for a group of `enemies`: S/E < T.
[[nodiscard]] bool overwhelmed(std::size_t interceptors, std::size_t enemies, double ratio);

/// The paper's name: "AllClear", …
[[nodiscard]] std::string_view name(Situation situation);

void describe(SituationConfig& config, ParameterVisitor& visitor);

}  // namespace tacit
