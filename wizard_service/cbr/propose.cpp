#include "wizard_service/cbr/propose.h"

#include <algorithm>
#include <queue>
#include <set>

#include "idl/types/config_error.h"
#include "wizard_service/cbr/features.h"
#include "wizard_service/cbr/places.h"
#include "wizard_service/cbr/request.h"

namespace tacit::cbr {
namespace {

/// A way to share tasks out.
struct Sharing {
  std::string arrangement;
  std::vector<Squad> squads;
};

/// Where cases are looked for, and how many of a kind are wanted.
struct Search {
  const CaseIndex& index;
  std::size_t most;
};

std::string counted(std::size_t count, std::string_view what) {
  return std::to_string(count) + ' ' + std::string(what) + (count == 1 ? "" : "s");
}

Sharing all_together(std::size_t tasks, int robots) {
  Sharing sharing;
  sharing.squads.push_back({robots, {}});
  for (std::size_t i = 0; i < tasks; ++i) sharing.squads.front().tasks.push_back(i);
  const std::string work = tasks == 1 ? "the task" : "every task, in order";
  sharing.arrangement = robots == 1 ? "One robot does " + work + "."
                                    : counted(static_cast<std::size_t>(robots), "robot") + " do " +
                                          work + ", together.";
  return sharing;
}

/// How far it is from task to task, and to the first from the start.
std::vector<double> legs_of(const PlanRequest& request, const Terrain& terrain) {
  std::vector<double> legs;
  MapPoint before = terrain.start();
  for (const PlacedTask& task : request.tasks) {
    const MapPoint here{task.x_m, task.y_m};
    legs.push_back(1.0 + distance(here, before));
    before = here;
  }
  return legs;
}

/// Each squad goes on from where the one before ends; none is without a task.
Sharing shared_out(const PlanRequest& request, const Terrain& terrain, int robots) {
  const std::size_t tasks = request.tasks.size();
  const std::size_t squads = std::min(tasks, static_cast<std::size_t>(robots));
  const std::vector<double> legs = legs_of(request, terrain);
  double whole = 0.0;
  for (const double leg : legs) whole += leg;
  Sharing sharing;
  sharing.squads.resize(squads);
  double gone = 0.0;
  std::size_t squad = 0;
  for (std::size_t i = 0; i < tasks; ++i) {
    const std::size_t left = tasks - i;
    const bool full = gone >= whole * static_cast<double>(squad + 1) / static_cast<double>(squads);
    const bool must = left <= squads - 1 - squad;
    if (squad + 1 < squads && !sharing.squads[squad].tasks.empty() && (full || must)) ++squad;
    sharing.squads[squad].tasks.push_back(i);
    gone += legs[i];
  }
  const auto team = static_cast<std::size_t>(robots);
  for (std::size_t i = 0; i < squads; ++i) {
    sharing.squads[i].robots = static_cast<int>(team / squads + (i < team % squads ? 1 : 0));
  }
  sharing.arrangement =
      squads == tasks
          ? "Each of " + counted(tasks, "task") + " has robots of its own."
          : counted(tasks, "task") + " are shared out among " + counted(squads, "robot") + '.';
  return sharing;
}

std::vector<Ranked> cases_for(const PlanRequest& request, std::size_t task, int robots,
                              const Search& search) {
  Query query = query_for(request, request.tasks[task]);
  query.robots = robots;
  // A case for another task is no help, whatever else matches.
  std::vector<Ranked> found = search.index.retrieve(query, search.most);
  std::erase_if(found, [&](const Ranked& one) { return one.features.task != *query.task; });
  if (found.empty()) {
    throw ConfigError("task " + std::to_string(task + 1) + ": found no case for " +
                      std::string(word(*query.task)) + " among " +
                      counted(search.index.size(), "case") +
                      ", wanted at least one; `tacit cases import` takes some in");
  }
  return found;
}

/// One choice of a case for every task, as indices into its candidates.
struct Combination {
  std::int64_t sum = 0;
  std::vector<std::size_t> chosen;
};
struct Worse {
  bool operator()(const Combination& a, const Combination& b) const {
    return a.sum != b.sum ? a.sum < b.sum : a.chosen > b.chosen;
  }
};

/// The best combinations, best first, without making them all.
std::vector<Combination> best_combinations(const std::vector<std::vector<Ranked>>& candidates,
                                           std::size_t most) {
  const auto sum = [&](const std::vector<std::size_t>& chosen) {
    std::int64_t total = 0;
    for (std::size_t i = 0; i < chosen.size(); ++i) total += candidates[i][chosen[i]].rank;
    return total;
  };
  std::priority_queue<Combination, std::vector<Combination>, Worse> open;
  std::set<std::vector<std::size_t>> seen;
  std::vector<std::size_t> first(candidates.size(), 0);
  open.push({sum(first), first});
  seen.insert(first);
  std::vector<Combination> best;
  while (!open.empty() && best.size() < most) {
    best.push_back(open.top());
    open.pop();
    for (std::size_t i = 0; i < candidates.size(); ++i) {
      std::vector<std::size_t> next = best.back().chosen;
      if (++next[i] == candidates[i].size() || !seen.insert(next).second) continue;
      open.push({sum(next), next});
    }
  }
  return best;
}

void append_outlines(const PlanRequest& request, const Sharing& sharing, const Search& search,
                     std::vector<Outline>& outlines) {
  std::vector<std::vector<Ranked>> candidates(request.tasks.size());
  for (const Squad& squad : sharing.squads) {
    for (const std::size_t task : squad.tasks) {
      candidates[task] = cases_for(request, task, squad.robots, search);
    }
  }
  for (const Combination& one : best_combinations(candidates, search.most)) {
    Outline outline{sharing.arrangement, sharing.squads, {}, 0};
    for (std::size_t i = 0; i < candidates.size(); ++i) {
      outline.cases.push_back(candidates[i][one.chosen[i]]);
    }
    outline.rank = one.sum / static_cast<std::int64_t>(candidates.size());
    outlines.push_back(std::move(outline));
  }
}

/// As given, else those of the best cases for each task.
std::set<int> team_sizes(const PlanRequest& request, const Search& search) {
  if (request.robots) return {*request.robots};
  std::set<int> sizes;
  for (const PlacedTask& task : request.tasks) {
    for (const Ranked& one : search.index.retrieve(query_for(request, task), search.most)) {
      if (one.features.task == task.task) sizes.insert(one.features.robots);
    }
  }
  return sizes.empty() ? std::set<int>{1} : sizes;
}

}  // namespace

std::vector<Outline> propose(const PlanRequest& request, const Terrain& terrain,
                             const CaseIndex& index, std::size_t most) {
  const Search search{index, most};
  std::vector<Outline> outlines;
  for (const int robots : team_sizes(request, search)) {
    append_outlines(request, all_together(request.tasks.size(), robots), search, outlines);
    if (robots == 1 || request.tasks.size() == 1) continue;
    append_outlines(request, shared_out(request, terrain, robots), search, outlines);
  }
  std::stable_sort(outlines.begin(), outlines.end(),
                   [](const Outline& a, const Outline& b) { return a.rank > b.rank; });
  return outlines;
}

}  // namespace tacit::cbr
