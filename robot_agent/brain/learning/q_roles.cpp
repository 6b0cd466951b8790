#include "robot_agent/brain/learning/q_roles.h"

#include <array>

#include "idl/types/config_error.h"
#include "robot_agent/brain/learning/policy_text.h"

namespace tacit {

QRoles::QRoles(const Config& config, const Self& self)
    : RoleSelector("q"),
      robot_(self.robot),
      rewards_(config.rewards),
      action_timeout_(static_cast<Tick>(config.action_timeout_ticks)),
      learner_({kInternalStates, kRoles}, config.learner,
               {Stream(self.seed, "initial q", self.robot.value),
                Stream(self.seed, "role choice", self.robot.value)}) {}

Role QRoles::choose(const RoleCue& cue) {
  const bool changed = cue.triggers != triggers_;
  triggers_ = cue.triggers;
  if (!learner_.last() || cue.revived) {
    query(cue, role_, 0.0);
  } else if (!reinforced(cue)) {
    const bool timed_out = cue.around.tick >= last_query_ + action_timeout_;
    if (changed || timed_out) query(cue, role_, 0.0);
  }
  return role_;
}

// Several deeds in one tick are as many queries, all from the state in which the tick found the
// robot.
bool QRoles::reinforced(const RoleCue& cue) {
  struct Reinforcer {
    bool matches;
    double value;
  };
  const Deeds& deeds = cue.around.deeds;
  const Role played = role_;
  bool any = false;
  for (const Reinforcer& each : {
           Reinforcer{deeds.stored, rewards_.mine},
           Reinforcer{deeds.revived && played == Role::Mechanic, rewards_.aid},
           Reinforcer{deeds.intercepted && played == Role::Soldier, rewards_.intercept},
       }) {
    if (!each.matches || each.value == 0.0) continue;
    query(cue, played, each.value);
    any = true;
  }
  return any;
}

void QRoles::query(const RoleCue& cue, Role played, double reward) {
  role_ = static_cast<Role>(learner_.query(internal_state(cue.triggers, played), reward));
  last_query_ = cue.around.tick;
}

std::string QRoles::policy() const { return to_text({robot_, learner_.table()}); }

void QRoles::inherit(std::string_view policy, std::string_view name) {
  PolicyTable found = parse_policy(policy, name);
  if (found.robot != robot_) {
    throw ConfigError(std::string(name) + ": robot is " + std::to_string(found.robot.value) +
                      ", wanted " + std::to_string(robot_.value));
  }
  learner_.inherit(std::move(found.table));
}

void QRoles::note(RunStand& stand) const {
  stand.last = learner_.last();
  stand.last_tick = last_query_;
  stand.triggers = triggers_.bits;
  stand.chance = learner_.exploration_position();
}

bool QRoles::resume(const RunStand& stand, std::string_view policy) {
  const bool in_range =
      stand.triggers < kTriggerSets &&
      (!stand.last || (stand.last->state < kInternalStates && stand.last->action < kRoles));
  if (!in_range) return false;
  PolicyTable found;
  try {
    found = parse_policy(policy, "memory");
  } catch (const ConfigError&) {
    return false;
  }
  if (found.robot != robot_) return false;
  learner_.resume(std::move(found.table), stand.last, stand.chance);
  role_ = role_called(stand.role).value_or(Role::Forager);
  triggers_ = {static_cast<std::uint8_t>(stand.triggers)};
  last_query_ = stand.last_tick;
  return true;
}

void describe(QRoles::Config& config, ParameterVisitor& visitor) {
  visitor.section("brain.q", "Q-learning of roles.");
  describe(config.learner, visitor);
  visitor.integer(
      "action_timeout_ticks", config.action_timeout_ticks, {1, 1e9},
      {"ticks", "After so long without a query the table is queried anyhow [MissionLab]."});
  visitor.number("invasion_m", config.ranges.invasion_m, {0.0, 1000.0},
                 {"m", "Range within which an enemy is an invasion [paper]."});
  visitor.number("die_off_m", config.ranges.die_off_m, {0.0, 1000.0},
                 {"m", "Range within which a disabled robot is a die-off [paper]."});
  visitor.section("brain.q.rewards", "What deeds are worth; 0 is no reinforcement.");
  constexpr Range kValue{-1e6, 1e6};
  visitor.number("mine", config.rewards.mine, kValue, {"", "A mine stored at the base [paper]."});
  visitor.number("aid", config.rewards.aid, kValue,
                 {"", "A teammate revived in the role of a Mechanic [paper]."});
  visitor.number("intercept", config.rewards.intercept, kValue,
                 {"", "An enemy destroyed in the role of a Soldier; none [paper]."});
}

void check(const QRoles::Config& config) { check(config.learner); }

}  // namespace tacit
