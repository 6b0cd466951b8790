#include "robot_agent/brain/brain.h"

#include "robot_agent/brain/forage_mind.h"
#include "robot_agent/brain/guard_mind.h"
#include "robot_agent/brain/operation_mind.h"

namespace tacit {
namespace {

std::unique_ptr<Mind> make_mind(const BrainConfig& config, const Self& self) {
  check(config);
  switch (config.mission) {
    case MissionKind::Guard:
      return std::make_unique<GuardMind>(config, self);
    case MissionKind::Forage:
      return std::make_unique<ForageMind>(config, self);
    case MissionKind::Operation:
      return std::make_unique<OperationMind>(config, self);
  }
  return nullptr;
}

}  // namespace

Brain::Brain(const BrainConfig& config, RobotId robot, std::uint64_t seed)
    : mind_(make_mind(config, Self{robot, seed})) {}
Brain::~Brain() = default;
Brain::Brain(Brain&&) noexcept = default;
Brain& Brain::operator=(Brain&&) noexcept = default;

Command Brain::decide(const Percept& percept) { return mind_->decide(percept); }

void Brain::report(Telemetry& out) const { mind_->report(out); }

std::string Brain::memory(std::string_view policy) const { return mind_->memory(policy); }

bool Brain::recall(std::string_view memory) { return mind_->recall(memory); }

std::uint64_t Brain::lessons() const { return mind_->lessons(); }

std::string Brain::policy() const { return mind_->policy(); }

void Brain::inherit(std::string_view policy, std::string_view name) {
  mind_->inherit(policy, name);
}

}  // namespace tacit
