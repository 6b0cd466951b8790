#include "deploy/experiment/grouping.h"

#include <algorithm>
#include <set>

namespace tacit {
namespace {

std::vector<Group> grouped(const Battery& battery, bool rivals) {
  std::vector<Group> groups;
  for (std::size_t i = 0; i < battery.cells().size(); ++i) {
    const Cell& cell = battery.cells()[i];
    if (cell.rival != rivals) {
      continue;
    }
    const std::string name = cell.level("variant");
    auto group = std::find_if(groups.begin(), groups.end(),
                              [&name](const Group& each) { return each.name == name; });
    if (group == groups.end()) {
      group = groups.insert(groups.end(), Group{name, {}});
    }
    group->cells.push_back(i);
  }
  return groups;
}

}  // namespace

std::vector<Group> by_variant(const Battery& battery) { return grouped(battery, false); }

std::vector<Group> by_rival(const Battery& battery) { return grouped(battery, true); }

Group all_variants(const Battery& battery) {
  Group all{"all", {}};
  for (std::size_t i = 0; i < battery.cells().size(); ++i) {
    if (!battery.cells()[i].rival) {
      all.cells.push_back(i);
    }
  }
  return all;
}

Group with_robots(const Battery& battery, const Group& group, std::int64_t robots) {
  Group some{group.name, {}};
  std::copy_if(group.cells.begin(), group.cells.end(), std::back_inserter(some.cells),
               [&](std::size_t cell) { return battery.cells()[cell].robots == robots; });
  return some;
}

std::vector<std::int64_t> team_sizes(const Battery& battery) {
  std::set<std::int64_t> sizes;
  for (const Cell& cell : battery.cells()) {
    sizes.insert(cell.robots);
  }
  return {sizes.begin(), sizes.end()};
}

std::vector<double> values(const Results& results, const Group& group, const std::string& measure) {
  std::vector<double> all;
  for (const std::size_t cell : group.cells) {
    const std::vector<double> some = values(results.sample(cell, measure));
    all.insert(all.end(), some.begin(), some.end());
  }
  return all;
}

}  // namespace tacit
