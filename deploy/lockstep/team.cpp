#include "deploy/lockstep/team.h"

#include <cassert>
#include <utility>

namespace tacit {

Team::Team(const WorldConfig& world, const BrainConfig& brain, std::uint64_t seed)
    : world_(world, seed) {
  for (const Percept& percept : world_.percepts()) {
    brains_.emplace_back(brain, percept.robot, seed);
  }
  commands_.resize(brains_.size());
}

void Team::inherit(std::span<const PolicyText> policies) {
  assert(policies.size() == brains_.size() && tick() == 0);
  for (std::size_t i = 0; i < policies.size(); ++i) {
    brains_[i].inherit(policies[i].text, policies[i].name);
  }
}

std::vector<std::string> Team::policies() const {
  std::vector<std::string> policies;
  for (const Brain& brain : brains_) {
    policies.push_back(brain.policy());
  }
  return policies;
}

std::span<const Event> Team::step() {
  if (observer_) {
    observer_(TeamPhase::Between);
  }
  const std::span<const Percept> percepts = world_.percepts();
  for (std::size_t i = 0; i < brains_.size(); ++i) {
    commands_[i] = brains_[i].decide(percepts[i]);
  }
  if (observer_) {
    observer_(TeamPhase::Decisions);
  }
  return world_.step(commands_);
}

void Team::on_phase(std::function<void(TeamPhase)> observer) {
  observer_ = std::move(observer);
  if (!observer_) {
    return world_.on_phase({});
  }
  world_.on_phase([this](WorldPhase phase) {
    constexpr auto kFirst = static_cast<int>(TeamPhase::Intent);
    observer_(static_cast<TeamPhase>(kFirst + static_cast<int>(phase)));
  });
}

}  // namespace tacit
