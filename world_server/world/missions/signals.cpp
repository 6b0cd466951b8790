#include "world_server/world/missions/signals.h"

#include "idl/types/random.h"

namespace tacit {

Signals::Signals(const SignalConfig& config, std::uint64_t seed, std::size_t robots)
    : config_(config), seed_(seed), heard_(robots) {}

void Signals::spread(Stage& stage, LineOfSight& sight) {
  for (std::vector<Word>& heard : heard_) {
    heard.clear();
  }
  for (std::size_t i = 0; i < heard_.size(); ++i) {
    if (stage.able(i) && stage.act(i) == Act::Signal) {
      sight.look_from(stage.place_m(i));
      say(i, stage, sight);
    }
  }
}

void Signals::say(std::size_t speaker, Stage& stage, const LineOfSight& sight) {
  const Word& word = stage.wanted(speaker).word;
  std::uint32_t count = 0;
  for (std::size_t i = 0; i < heard_.size(); ++i) {
    const WorldVec offset = stage.place_m(i) - stage.place_m(speaker);
    if (i != speaker && heard_[i].size() < Percept::kMaxHeard && reaches(offset, sight) &&
        !misses(i, speaker, stage.tick())) {
      heard_[i].push_back(word);
      ++count;
    }
  }
  stage.deeds(speaker).signalled = true;
  stage.report(Signalled{stage.id_of(speaker), word, count});
}

bool Signals::reaches(const WorldVec& offset, const LineOfSight& sight) const {
  return offset.squared_norm() <= config_.range_m * config_.range_m &&
         (!config_.blocked_by_walls || sight.clear(offset));
}

bool Signals::misses(std::size_t hearer, std::size_t speaker, Tick tick) const {
  if (config_.missed_share <= 0.0) {
    return false;
  }
  Stream chance(seed_, "missed signals", hearer + 1);
  chance.seek(tick * heard_.size() + speaker);
  return chance.uniform() < config_.missed_share;
}

}  // namespace tacit
