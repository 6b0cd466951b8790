#include "robot_agent/brain/perception/situation.h"

#include <algorithm>

namespace tacit {

Situation situation(const Surroundings& around, const Occlusion& occlusion,
                    const SituationConfig& config) {
  if (around.groups.empty()) return Situation::AllClear;
  if (const EnemyGroup* open = around.open_group) {
    const bool guarding =
        around.target_m && between(*around.target_m, open->centroid_m, config.between_lateral_m);
    return guarding ? Situation::ClearToEnemy : Situation::FlankingEnemy;
  }
  const auto needs_help = [&](const EnemyGroup& group) {
    return overwhelmed(occlusion.interceptors(group.centroid_m, around.teammates), group.size,
                       config.overwhelmed_ratio);
  };
  return std::any_of(around.groups.begin(), around.groups.end(), needs_help)
             ? Situation::SoldierNeedsHelp
             : Situation::NoSoldiersNeedHelp;
}

bool between(const BodyVec& target_m, const BodyVec& group_m, double lateral_m) {
  const BodyVec segment_m = group_m - target_m;
  const double squared_length = segment_m.squared_norm();
  const double along = -target_m.dot(segment_m);
  const double across = target_m.cross(segment_m);
  return squared_length > 0.0 && along >= 0.0 && along <= squared_length &&
         across * across <= lateral_m * lateral_m * squared_length;
}

bool overwhelmed(std::size_t interceptors, std::size_t enemies, double ratio) {
  return static_cast<double>(interceptors) < ratio * static_cast<double>(enemies);
}

std::string_view name(Situation situation) {
  switch (situation) {
    case Situation::AllClear:
      return "AllClear";
    case Situation::ClearToEnemy:
      return "ClearToEnemy";
    case Situation::FlankingEnemy:
      return "FlankingEnemy";
    case Situation::SoldierNeedsHelp:
      return "SoldierNeedsHelp";
    case Situation::NoSoldiersNeedHelp:
      return "NoSoldiersNeedHelp";
  }
  return {};
}

void describe(SituationConfig& config, ParameterVisitor& visitor) {
  visitor.section("brain.situation", "The borders between the five situations.");
  visitor.number("between_lateral_m", config.between_lateral_m, {0.0, 1000.0},
                 {"m",
                  "How far beside the line from target to group a soldier still stands between "
                  "them [ours: the paper names the relation without a width]."});
  visitor.number("overwhelmed_ratio", config.overwhelmed_ratio, {0.0, 100.0},
                 {"",
                  "A group overwhelms its interceptors when there are fewer of them per enemy than "
                  "this [paper]."});
}

}  // namespace tacit
