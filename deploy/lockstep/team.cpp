#include "deploy/lockstep/team.h"

namespace tacit {

Team::Team(const WorldConfig& world, const BrainConfig& brain, std::uint64_t seed)
    : world_(world, seed) {
  for (const Percept& percept : world_.percepts()) {
    brains_.emplace_back(brain, percept.robot, seed);
  }
  commands_.resize(brains_.size());
}

std::span<const Event> Team::step() {
  const std::span<const Percept> percepts = world_.percepts();
  for (std::size_t i = 0; i < brains_.size(); ++i) {
    commands_[i] = brains_[i].decide(percepts[i]);
  }
  return world_.step(commands_);
}

}  // namespace tacit
