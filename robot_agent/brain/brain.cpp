#include "robot_agent/brain/brain.h"

#include <utility>

#include "robot_agent/brain/assemblage/actuator.h"
#include "robot_agent/brain/assemblage/assemblage.h"
#include "robot_agent/brain/learning/fixed_gains.h"
#include "robot_agent/brain/learning/learning_momentum.h"
#include "robot_agent/brain/perception/perception.h"

namespace tacit {
namespace {

const BrainConfig& checked(const BrainConfig& config) {
  check(config);
  return config;
}

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

class Brain::Mind {
 public:
  Mind(const BrainConfig& config, const Self& self)
      : robot_(self.robot),
        learner_name_(checked(config).learner),
        learner_(make_learner(config)),
        perception_(EnemyGroups(config.enemy_groups), Occlusion(config.occlusion),
                    attention(config, *learner_)),
        assemblage_(config.schemas, self, learner_->ceiling()),
        actuator_(config.actuator) {}

  Command decide(const Percept& percept) {
    const Surroundings& around = perception_.look(percept);
    learner_->learn(around);
    const BodyVec sum = assemblage_.sum(around, learner_->gains());
    const BodyVec velocity_mps = actuator_.velocity_mps(sum);
    tick_ = percept.tick;
    return {robot_, tick_, velocity_mps, actuator_.turn_radps(velocity_mps)};
  }

  void report(Telemetry& out) const {
    out.robot = robot_;
    out.tick = tick_;
    out.learner = learner_name_;
    out.situation = learner_->situation();
    assemblage_.report(out.shares);
  }

  [[nodiscard]] Learner& learner() { return *learner_; }

 private:
  RobotId robot_;
  Tick tick_ = 0;
  std::string learner_name_;
  std::unique_ptr<Learner> learner_;
  Perception perception_;
  Assemblage assemblage_;
  Actuator actuator_;
};

Brain::Brain(const BrainConfig& config, RobotId robot, std::uint64_t seed)
    : mind_(std::make_unique<Mind>(config, Self{robot, seed})) {}
Brain::~Brain() = default;
Brain::Brain(Brain&&) noexcept = default;
Brain& Brain::operator=(Brain&&) noexcept = default;

Command Brain::decide(const Percept& percept) { return mind_->decide(percept); }

void Brain::report(Telemetry& out) const { mind_->report(out); }

std::string Brain::memory() const { return mind_->learner().memory(); }

bool Brain::recall(std::string_view memory) { return mind_->learner().recall(memory); }

}  // namespace tacit
