#include "robot_agent/brain/learning/role_triggers.h"

namespace tacit {

TriggerSet role_triggers(const Surroundings& around, const TriggerRanges& ranges) {
  const Nearest& enemy = around.nearest_of(Thing::Enemy);
  const Nearest& dead = around.nearest_of(Thing::Disabled);
  const std::array<bool, kRoleTriggers.size()> fires{
      enemy.known(),
      enemy.known() && enemy.within(ranges.invasion_m),
      dead.known(),
      dead.known() && dead.within(ranges.die_off_m),
  };
  unsigned bits = 0;
  for (std::size_t i = 0; i < fires.size(); ++i) bits |= static_cast<unsigned>(fires[i]) << i;
  return {static_cast<std::uint8_t>(bits)};
}

bool feasible(TriggerSet triggers) {
  for (std::size_t i = 0; i < kRoleTriggers.size(); ++i) {
    const auto implied = kRoleTriggers[i].implies;
    if (triggers.has(i) && implied && !triggers.has(*implied)) return false;
  }
  return true;
}

std::string words(TriggerSet triggers) {
  std::string text;
  for (std::size_t i = 0; i < kRoleTriggers.size(); ++i) {
    if (!triggers.has(i)) continue;
    if (!text.empty()) text += '+';
    text += kRoleTriggers[i].name;
  }
  return text;
}

std::optional<TriggerSet> triggers_in(std::string_view words) {
  for (std::size_t bits = 0; bits < kTriggerSets; ++bits) {
    const TriggerSet triggers{static_cast<std::uint8_t>(bits)};
    if (tacit::words(triggers) == words) return triggers;
  }
  return std::nullopt;
}

}  // namespace tacit
