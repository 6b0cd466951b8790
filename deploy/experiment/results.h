#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "console/record/run_store.h"
#include "console/report/table.h"
#include "deploy/experiment/battery.h"

namespace tacit {

/// One measure of the runs of one cell, by seed; runs without it are left out.
using Sample = std::map<std::int64_t, double>;

[[nodiscard]] std::vector<double> values(const Sample& sample);

/// The values that two samples have for the same seeds, side by side.
[[nodiscard]] std::pair<std::vector<double>, std::vector<double>> paired(const Sample& a,
                                                                         const Sample& b);

/// What a store holds of an experiment's runs, cell by cell.
class Results {
 public:
  /// Those on the seeds of training.
  Results(const Battery& battery, const RunStore& store)
      : Results(battery, store, battery.runs()) {}
  Results(const Battery& battery, const RunStore& store, std::span<const PlannedRun> runs);

  [[nodiscard]] std::size_t count(std::size_t cell) const { return runs_[cell].size(); }
  [[nodiscard]] Sample sample(std::size_t cell, const std::string& measure) const;

  /// The cell with these levels and this team size; absent when there is none.
  [[nodiscard]] std::optional<std::size_t> find(const std::vector<Setting>& levels,
                                                std::int64_t robots) const;

 private:
  const Battery& battery_;
  std::vector<std::vector<std::pair<std::int64_t, RunOutcome>>> runs_;
};

/// "enemies.strategy" is headed "strategy".
[[nodiscard]] std::string short_name(const std::string& path);

/// As a table's cell; nothing for an absent value.
[[nodiscard]] TableCell cell_of(const std::optional<Estimate>& estimate);
[[nodiscard]] TableCell cell_of(const std::optional<double>& measure);
/// As a table's cell; nothing for an empty text.
[[nodiscard]] TableCell cell_of(const std::string& text);

}  // namespace tacit
