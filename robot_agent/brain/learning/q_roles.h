#pragma once

#include "robot_agent/brain/learning/q_learner.h"
#include "robot_agent/brain/learning/role_selector.h"
#include "robot_agent/brain/schemas/schema.h"

namespace tacit {

/// Learns which role to play in which internal state (paper, section 3; MissionLab's QLEARN).
///
/// The table is queried when a reward comes in, when the triggers have changed, when a role has
/// been played for long, in the first tick, and on revival. Between queries the role stays.
class QRoles final : public RoleSelector {
 public:
  /// What a deed is worth; 0 is no reinforcement.
  struct Rewards {
    double mine = 20.0;      ///< A mine stored at the base.
    double aid = 10.0;       ///< A teammate revived, in the role of a Mechanic.
    double intercept = 0.0;  ///< An enemy destroyed, in the role of a Soldier.
  };
  struct Config {
    QLearner::Config learner;
    std::int64_t action_timeout_ticks = 300;
    TriggerRanges ranges;
    Rewards rewards;
  };
  QRoles(const Config& config, const Self& self);

  [[nodiscard]] Role choose(const RoleCue& cue) override;
  [[nodiscard]] std::string policy() const override;
  void inherit(std::string_view policy, std::string_view name) override;
  [[nodiscard]] std::uint64_t lessons() const override { return learner_.table().updates; }
  void note(RunStand& stand) const override;
  [[nodiscard]] bool resume(const RunStand& stand, std::string_view policy) override;

 private:
  [[nodiscard]] bool reinforced(const RoleCue& cue);
  void query(const RoleCue& cue, Role played, double reward);

  RobotId robot_;
  Rewards rewards_;
  Tick action_timeout_;
  QLearner learner_;
  Role role_ = Role::Forager;  ///< The one played; before the first query, the paper's default.
  TriggerSet triggers_;        ///< In the last tick.
  Tick last_query_ = 0;
};

void describe(QRoles::Config& config, ParameterVisitor& visitor);

/// Throws ConfigError when two parameters contradict.
void check(const QRoles::Config& config);

}  // namespace tacit
