#pragma once

#include <array>
#include <string>
#include <string_view>

#include "idl/types/mission_kind.h"
#include "idl/types/operation_script.h"
#include "idl/types/parameters.h"
#include "robot_agent/brain/assemblage/actuator.h"
#include "robot_agent/brain/learning/heterogeneous.h"
#include "robot_agent/brain/learning/learning_momentum.h"
#include "robot_agent/brain/learning/q_roles.h"
#include "robot_agent/brain/perception/enemy_groups.h"
#include "robot_agent/brain/perception/occlusion.h"
#include "robot_agent/brain/perception/situation.h"
#include "robot_agent/brain/roles/roles_config.h"
#include "robot_agent/brain/schemas/registry.h"

namespace tacit {

/// What can set the gains of a guard: the paper's three soldier types, and `crowd`, robots that
/// wander to a goal.
inline constexpr std::array<std::string_view, 4> kGuardLearners{"static1", "static2", "lm",
                                                                "crowd"};
/// What can choose the role of a forager team's robot.
inline constexpr std::array<std::string_view, 3> kForageLearners{"q", "homogeneous",
                                                                 "heterogeneous"};

/// What decides in an operation.
inline constexpr std::array<std::string_view, 1> kOperationLearners{"mission"};

[[nodiscard]] Gains static1_gains();
[[nodiscard]] Gains static2_gains();
[[nodiscard]] Gains crowd_gains();
[[nodiscard]] LearningMomentum::Config learning_momentum_config();

/// All that makes one brain differ from another, its robot and the seed apart. The defaults are a
/// soldier of the paper's section 2.
struct BrainConfig {
  MissionKind mission = MissionKind::Guard;
  std::string learner = "lm";  ///< One of the mission's.

  // Of both missions.
  SchemaConfigs schemas;
  Actuator::Config actuator;

  // A guard's.
  EnemyGroups::Config enemy_groups;
  Occlusion::Config occlusion;
  SituationConfig situation;
  Gains static1 = static1_gains();
  Gains static2 = static2_gains();
  Gains crowd = crowd_gains();
  LearningMomentum::Config lm = learning_momentum_config();

  // A forager's.
  RolesConfig roles;
  QuarryTrack::Config pursuit{.average_ticks = 5, .gate_m = 0.75};
  Heterogeneous::Config heterogeneous;
  QRoles::Config q;

  // An operation's; described by itself, for the world reads it too.
  OperationScript script;

  /// The parameters of schema `S`.
  template <class S>
  [[nodiscard]] typename S::Config& of() {
    return std::get<typename S::Config>(schemas);
  }
};

/// The defaults for a mission.
[[nodiscard]] BrainConfig brain_defaults(MissionKind mission);

/// Whether such a brain learns anything that another run could use.
[[nodiscard]] inline bool learns(const BrainConfig& config) {
  return config.learner == "lm" || config.learner == "q";
}

/// Every parameter that the mission has.
void describe(BrainConfig& config, ParameterVisitor& visitor);

/// Throws ConfigError, naming the parameter, when one is out of its range or two contradict.
void check(const BrainConfig& config);

}  // namespace tacit
