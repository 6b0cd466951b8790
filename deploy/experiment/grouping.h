#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "deploy/experiment/battery.h"
#include "deploy/experiment/results.h"

namespace tacit {

/// Cells that are averaged over together.
struct Group {
  std::string name;  ///< A variant's; empty where there are none.
  std::vector<std::size_t> cells;
};

/// A group for every variant; a single one where there are none. Rivals belong to none.
[[nodiscard]] std::vector<Group> by_variant(const Battery& battery);
/// A group for every rival.
[[nodiscard]] std::vector<Group> by_rival(const Battery& battery);
/// All cells that are not rivals.
[[nodiscard]] Group all_variants(const Battery& battery);
/// Those cells of a group that have this team size.
[[nodiscard]] Group with_robots(const Battery& battery, const Group& group, std::int64_t robots);
/// Those of the battery, ascending.
[[nodiscard]] std::vector<std::int64_t> team_sizes(const Battery& battery);

/// The values of a measure in all runs of a group.
[[nodiscard]] std::vector<double> values(const Results& results, const Group& group,
                                         const std::string& measure);

}  // namespace tacit
