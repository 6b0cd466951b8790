#pragma once

#include <span>
#include <vector>

#include "idl/types/parameters.h"
#include "robot_agent/brain/perception/surroundings.h"

namespace tacit {

/// Tells which enemies hang together: those within the linking distance of each other, and so on
/// along the chain.
class EnemyGroups {
 public:
  struct Config {
    double linking_distance_m = 15.0;
  };
  explicit EnemyGroups(const Config& config);

  /// Writes the groups of `enemies` to `groups`; reorders `enemies`.
  void find(std::vector<Seen>& enemies, std::vector<EnemyGroup>& groups) const;

 private:
  [[nodiscard]] std::size_t gather(std::span<Seen> enemies) const;

  double squared_link_m2_;
};

/// The nearest of `groups` by its nearest member; null when there is none.
[[nodiscard]] const EnemyGroup* nearest_group(std::span<const EnemyGroup> groups);

void describe(EnemyGroups::Config& config, ParameterVisitor& visitor);

}  // namespace tacit
