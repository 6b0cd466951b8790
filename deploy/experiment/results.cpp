#include "deploy/experiment/results.h"

#include <algorithm>

namespace tacit {

std::vector<double> values(const Sample& sample) {
  std::vector<double> all;
  for (const auto& [seed, value] : sample) {
    all.push_back(value);
  }
  return all;
}

std::pair<std::vector<double>, std::vector<double>> paired(const Sample& a, const Sample& b) {
  std::pair<std::vector<double>, std::vector<double>> both;
  for (const auto& [seed, value] : a) {
    if (const auto other = b.find(seed); other != b.end()) {
      both.first.push_back(value);
      both.second.push_back(other->second);
    }
  }
  return both;
}

Results::Results(const Battery& battery, const RunStore& store, std::span<const PlannedRun> runs)
    : battery_(battery), runs_(battery.cells().size()) {
  for (const PlannedRun& run : runs) {
    if (std::optional<RunRow> row = store.find(run.key); row && row->outcome.complete) {
      runs_[run.cell].emplace_back(run.seed, std::move(row->outcome));
    }
  }
}

Sample Results::sample(std::size_t cell, const std::string& measure) const {
  Sample sample;
  for (const auto& [seed, outcome] : runs_[cell]) {
    if (const std::optional<double> value = outcome.metric(measure)) {
      sample.emplace(seed, *value);
    }
  }
  return sample;
}

std::optional<std::size_t> Results::find(const std::vector<Setting>& levels,
                                         std::int64_t robots) const {
  const auto& cells = battery_.cells();
  const auto found = std::find_if(cells.begin(), cells.end(), [&](const Cell& cell) {
    return cell.robots == robots && cell.levels == levels;
  });
  return found != cells.end() ? std::optional(static_cast<std::size_t>(found - cells.begin()))
                              : std::nullopt;
}

std::string short_name(const std::string& path) { return path.substr(path.rfind('.') + 1); }

TableCell cell_of(const std::optional<Estimate>& estimate) {
  return estimate ? TableCell{*estimate} : TableCell{};
}

TableCell cell_of(const std::optional<double>& measure) {
  return measure ? TableCell{*measure} : TableCell{};
}

TableCell cell_of(const std::string& text) { return text.empty() ? TableCell{} : TableCell{text}; }

}  // namespace tacit
