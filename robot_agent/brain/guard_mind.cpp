#include "robot_agent/brain/guard_mind.h"

#include "idl/types/config_error.h"
#include "robot_agent/brain/learning/fixed_gains.h"
#include "robot_agent/brain/learning/learning_momentum.h"

namespace tacit {
namespace {

std::unique_ptr<Learner> make_learner(const BrainConfig& config) {
  if (config.learner == "lm") {
    return std::make_unique<LearningMomentum>(config.lm, config.situation,
                                              Occlusion(config.occlusion));
  }
  const Gains& gains = config.learner == "static1"   ? config.static1
                       : config.learner == "static2" ? config.static2
                                                     : config.crowd;
  return std::make_unique<FixedGains>(config.learner, gains);
}

// Enemies matter to who intercepts them and to who judges situations.
Attention attention(const BrainConfig& config, const Learner& learner) {
  const bool intercepts = learner.ceiling().of<InterceptEnemies>() > 0.0;
  return intercepts || config.learner == "lm" ? Attention::Everything : Attention::NoEnemies;
}

}  // namespace

GuardMind::GuardMind(const BrainConfig& config, const Self& self)
    : robot_(self.robot),
      learner_name_(config.learner),
      learner_(make_learner(config)),
      perception_(EnemyGroups(config.enemy_groups), Occlusion(config.occlusion),
                  attention(config, *learner_)),
      assemblage_(config.schemas, self, learner_->ceiling()),
      actuator_(config.actuator) {}

Command GuardMind::decide(const Percept& percept) {
  const Surroundings& around = perception_.look(percept);
  learner_->learn(around);
  const BodyVec sum = assemblage_.sum(around, learner_->gains());
  const BodyVec velocity_mps = actuator_.velocity_mps(sum);
  tick_ = percept.tick;
  return {robot_, tick_, velocity_mps, actuator_.turn_radps(velocity_mps)};
}

void GuardMind::report(Telemetry& out) const {
  out.robot = robot_;
  out.tick = tick_;
  out.learner = learner_name_;
  out.situation = learner_->situation();
  out.role.clear();
  out.state.clear();
  assemblage_.report(out.shares);
}

void GuardMind::inherit(std::string_view policy, std::string_view name) {
  if (learner_->recall(policy)) return;
  throw ConfigError(std::string(name) + ": is not a policy of learner " + learner_name_ +
                    ": found " + std::string(policy.substr(0, 60)) + ", wanted one like " +
                    learner_->memory());
}

}  // namespace tacit
