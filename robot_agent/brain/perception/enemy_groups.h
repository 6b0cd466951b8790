#pragma once

#include <span>
#include <vector>

#include "idl/types/parameters.h"
#include "robot_agent/brain/perception/surroundings.h"

namespace tacit {

/// Tells which enemies hang together, and which teammates have taken each group on.
///
/// Enemies within the linking distance of each other are in one group, and so on along the chain.
/// An able teammate intercepts a group when it is nearer to the group's centroid than this robot
/// and lies within the occlusion angle of the line of sight to it; it occludes the group.
class EnemyGroups {
 public:
  struct Config {
    double linking_distance_m = 15.0;
    double occlusion_deg = 15.0;  ///< To either side of the line of sight.
  };
  explicit EnemyGroups(const Config& config);

  /// Writes the groups of `enemies` to `groups`; reorders `enemies`.
  void find(std::vector<Seen>& enemies, std::span<const Seen> teammates,
            std::vector<EnemyGroup>& groups) const;

 private:
  [[nodiscard]] std::size_t gather(std::span<Seen> enemies) const;
  [[nodiscard]] std::size_t interceptors(const BodyVec& group_m,
                                         std::span<const Seen> teammates) const;

  double squared_link_m2_;
  double cos_occlusion_;
};

/// The nearest of `groups` by its nearest member; null when there is none.
[[nodiscard]] const EnemyGroup* nearest_group(std::span<const EnemyGroup> groups);

/// The nearest group that no teammate occludes; null when there is none.
[[nodiscard]] const EnemyGroup* nearest_open_group(std::span<const EnemyGroup> groups);

void describe(EnemyGroups::Config& config, ParameterVisitor& visitor);

}  // namespace tacit
