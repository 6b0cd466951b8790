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
    : squared_link_m2_(config.linking_distance_m * config.linking_distance_m),
      cos_occlusion_(sin_cos(config.occlusion_deg * kPi / 180.0).cos) {}

void EnemyGroups::find(std::vector<Seen>& enemies, std::span<const Seen> teammates,
                       std::vector<EnemyGroup>& groups) const {
  groups.clear();
  for (std::span<Seen> rest(enemies); !rest.empty();) {
    const std::size_t size = gather(rest);
    EnemyGroup& group = groups.emplace_back(summary(rest.first(size)));
    group.interceptors = interceptors(group.centroid_m, teammates);
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

std::size_t EnemyGroups::interceptors(const BodyVec& group_m,
                                      std::span<const Seen> teammates) const {
  const double squared_range_m2 = group_m.squared_norm();
  const double least_cos_m = cos_occlusion_ * std::sqrt(squared_range_m2);
  std::size_t count = 0;
  for (const Seen& mate : teammates) {
    const bool nearer_to_group = (group_m - mate.offset_m).squared_norm() < squared_range_m2;
    const bool in_line = mate.offset_m.dot(group_m) >= least_cos_m * mate.range_m;
    count += static_cast<std::size_t>(mate.able && nearer_to_group && in_line);
  }
  return count;
}

const EnemyGroup* nearest_group(std::span<const EnemyGroup> groups) {
  const EnemyGroup* best = nullptr;
  for (const EnemyGroup& group : groups) {
    if (best == nullptr || nearer(group.nearest, best->nearest)) best = &group;
  }
  return best;
}

const EnemyGroup* nearest_open_group(std::span<const EnemyGroup> groups) {
  const EnemyGroup* best = nullptr;
  for (const EnemyGroup& group : groups) {
    if (group.occluded()) continue;
    if (best == nullptr || nearer(group.nearest, best->nearest)) best = &group;
  }
  return best;
}

void describe(EnemyGroups::Config& config, ParameterVisitor& visitor) {
  visitor.section("brain.enemy_groups", "Which enemies are one group and who has taken it on.");
  visitor.number("linking_distance_m", config.linking_distance_m, {0.0, 1000.0},
                 {"m",
                  "Enemies this near to each other are in one group [ours: three times the spread "
                  "of a group of five at its creation]."});
  visitor.number("occlusion_deg", config.occlusion_deg, {0.0, 180.0},
                 {"deg",
                  "A nearer teammate this close to the line of sight occludes a group [ours: the "
                  "paper names occlusion without an angle]."});
}

}  // namespace tacit
