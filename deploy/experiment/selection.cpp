#include "deploy/experiment/selection.h"

#include <algorithm>

#include "deploy/experiment/results.h"

namespace tacit {
namespace {

bool meet(const Battery& battery, const Cell& a, const Cell& b) {
  return a.robots == b.robots && battery.scenario_name(a) == battery.scenario_name(b);
}

Contest& contest_of(const Battery& battery, std::vector<Contest>& all, const Cell& cell) {
  const auto found = std::find_if(all.begin(), all.end(), [&](const Contest& contest) {
    return meet(battery, battery.cells()[contest.candidates.front()], cell);
  });
  return found != all.end() ? *found : all.emplace_back();
}

}  // namespace

std::vector<Contest> contests(const Battery& battery) {
  std::vector<Contest> all;
  if (battery.config().select_by.empty()) {
    return all;
  }
  for (std::size_t i = 0; i < battery.cells().size(); ++i) {
    // Of each scenario and team size the rivals come after the candidates.
    const Cell& cell = battery.cells()[i];
    Contest& contest = contest_of(battery, all, cell);
    (cell.rival ? contest.rivals : contest.candidates).push_back(i);
  }
  return all;
}

std::optional<std::size_t> winner(const Battery& battery, const RunStore& store,
                                  const Contest& contest) {
  std::vector<PlannedRun> runs;
  for (const PlannedRun& run : battery.runs()) {
    if (std::count(contest.candidates.begin(), contest.candidates.end(), run.cell) > 0) {
      runs.push_back(run);
    }
  }
  const Results results(battery, store, runs);
  std::optional<std::size_t> best;
  double least = 0.0;
  for (const std::size_t cell : contest.candidates) {
    if (static_cast<std::int64_t>(results.count(cell)) < battery.cells()[cell].runs) {
      return std::nullopt;
    }
    const auto score = mean(values(results.sample(cell, battery.config().select_by)));
    if (score && (!best || *score < least)) {
      best = cell;
      least = *score;
    }
  }
  return best;
}

std::size_t held_out_count(const Battery& battery) {
  std::size_t cells = 0;
  for (const Contest& contest : contests(battery)) {
    cells += 1 + contest.rivals.size();
  }
  return cells * static_cast<std::size_t>(battery.config().held_out_runs);
}

std::vector<PlannedRun> held_out_runs(const Battery& battery, const RunStore& store) {
  std::vector<std::size_t> cells;
  for (const Contest& contest : contests(battery)) {
    if (const std::optional<std::size_t> best = winner(battery, store, contest)) {
      cells.push_back(*best);
      cells.insert(cells.end(), contest.rivals.begin(), contest.rivals.end());
    }
  }
  std::vector<PlannedRun> runs;
  for (std::int64_t k = 0; k < battery.config().held_out_runs; ++k) {
    for (const std::size_t cell : cells) {
      runs.push_back(battery.planned(cell, held_out_seed(battery.config(), k)));
    }
  }
  return runs;
}

}  // namespace tacit
