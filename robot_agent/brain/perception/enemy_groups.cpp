#include "robot_agent/brain/perception/enemy_groups.h"

#include <utility>

namespace tacit {
namespace {

EnemyGroup summary(std::span<const Seen> members) {
  EnemyGroup group{.size = members.size(), .centroid_m = {}, .nearest = members.front()};
  for (const Seen& member : members) {
    group.centroid_m += member.offset_m;
    if (nearer(member, group.nearest)) group.nearest = member;
  }
  group.centroid_m = (1.0 / static_cast<double>(members.size())) * group.centroid_m;
  return group;
}

}  // namespace

EnemyGroups::EnemyGroups(const Config& config)
    : squared_link_m2_(config.linking_distance_m * config.linking_distance_m) {}

void EnemyGroups::find(std::vector<Seen>& enemies, std::vector<EnemyGroup>& groups) const {
  groups.clear();
  for (std::span<Seen> rest(enemies); !rest.empty();) {
    const std::size_t size = gather(rest);
    groups.push_back(summary(rest.first(size)));
    rest = rest.subspan(size);
  }
}

// Moves the whole group of the first enemy to the front and returns its size. Each member found
// collects those within its own reach behind the members found so far.
std::size_t EnemyGroups::gather(std::span<Seen> enemies) const {
  std::size_t size = 1;
  for (std::size_t member = 0; member < size; ++member) {
    const BodyVec centre_m = enemies[member].offset_m;
    for (std::size_t other = size; other < enemies.size(); ++other) {
      if ((enemies[other].offset_m - centre_m).squared_norm() <= squared_link_m2_) {
        std::swap(enemies[other], enemies[size++]);
      }
    }
  }
  return size;
}

const EnemyGroup* nearest_group(std::span<const EnemyGroup> groups) {
  const EnemyGroup* best = nullptr;
  for (const EnemyGroup& group : groups) {
    if (best == nullptr || nearer(group.nearest, best->nearest)) best = &group;
  }
  return best;
}

void describe(EnemyGroups::Config& config, ParameterVisitor& visitor) {
  visitor.section("brain.enemy_groups", "Which enemies are one group.");
  visitor.number("linking_distance_m", config.linking_distance_m, {0.0, 1000.0},
                 {"m",
                  "Enemies this near to each other are in one group [ours: three times the spread "
                  "of a group of five at its creation]."});
}

}  // namespace tacit
