#include "deploy/experiment/summary.h"

#include <algorithm>
#include <map>
#include <optional>
#include <string>
#include <utility>

#include "console/report/estimate.h"
#include "console/report/holm.h"

namespace tacit {
namespace {

constexpr const char* kDeathDistance = "mean_death_distance_m";

/// One measure of the runs of one cell, by seed; runs without it are left out.
using Sample = std::map<std::int64_t, double>;

std::vector<double> values(const Sample& sample) {
  std::vector<double> all;
  for (const auto& [seed, value] : sample) {
    all.push_back(value);
  }
  return all;
}

/// The values that two samples have for the same seeds, side by side.
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

TableCell cell_of(const std::optional<Estimate>& estimate) {
  return estimate ? TableCell{*estimate} : TableCell{};
}

/// "enemies.strategy" is headed "strategy".
std::string short_name(const std::string& path) { return path.substr(path.rfind('.') + 1); }

class Results {
 public:
  Results(const Battery& battery, const RunStore& store)
      : battery_(battery), runs_(battery.cells().size()) {
    for (const PlannedRun& run : battery.runs()) {
      if (std::optional<RunRow> row = store.find(run.key)) {
        runs_[run.cell].emplace_back(run.seed, std::move(row->outcome));
      }
    }
  }

  [[nodiscard]] std::size_t count(std::size_t cell) const { return runs_[cell].size(); }

  [[nodiscard]] Sample sample(std::size_t cell, const std::string& measure) const {
    Sample sample;
    for (const auto& [seed, outcome] : runs_[cell]) {
      if (const std::optional<double> value = outcome.metric(measure)) {
        sample.emplace(seed, *value);
      }
    }
    return sample;
  }

  /// The cell that differs from `cell` only in its team size; absent when there is none.
  [[nodiscard]] std::optional<std::size_t> with_robots(std::size_t cell,
                                                       std::int64_t robots) const {
    return find(battery_.cells()[cell].levels, robots);
  }

  [[nodiscard]] std::optional<std::size_t> find(const std::vector<Setting>& levels,
                                                std::int64_t robots) const {
    const auto& cells = battery_.cells();
    const auto found = std::find_if(cells.begin(), cells.end(), [&](const Cell& cell) {
      return cell.robots == robots && cell.levels == levels;
    });
    return found != cells.end() ? std::optional(static_cast<std::size_t>(found - cells.begin()))
                                : std::nullopt;
  }

 private:
  const Battery& battery_;
  std::vector<std::vector<std::pair<std::int64_t, RunOutcome>>> runs_;
};

std::vector<Column> cell_columns(const Battery& battery) {
  std::vector<Column> columns;
  for (const Factor& factor : battery.factors()) {
    columns.push_back({short_name(factor.path), short_name(factor.path)});
  }
  columns.push_back({"robots", "robots"});
  columns.push_back({"runs", "runs"});
  return columns;
}

std::vector<TableCell> cell_heads(const Cell& cell, std::size_t runs) {
  std::vector<TableCell> heads;
  for (const Setting& level : cell.levels) {
    heads.emplace_back(level.value);
  }
  heads.emplace_back(cell.robots);
  heads.emplace_back(static_cast<std::int64_t>(runs));
  return heads;
}

Table cells_table(const Battery& battery, const Results& results) {
  Table table{battery.config().name + ": means with 95 % intervals", cell_columns(battery), {}};
  for (const std::string& measure : battery.config().measures) {
    table.columns.push_back({measure, measure, 2, true});
  }
  for (std::size_t i = 0; i < battery.cells().size(); ++i) {
    table.rows.push_back(cell_heads(battery.cells()[i], results.count(i)));
    for (const std::string& measure : battery.config().measures) {
      table.rows.back().push_back(cell_of(mean_estimate(values(results.sample(i, measure)))));
    }
  }
  return table;
}

Table improvement_table(const Battery& battery, const Results& results) {
  Table table{
      battery.config().name + ": improvement ratio P(n) / (n P(1))", cell_columns(battery), {}};
  table.columns.push_back({"improvement", "improvement", 3, true});
  for (std::size_t i = 0; i < battery.cells().size(); ++i) {
    const Cell& cell = battery.cells()[i];
    const std::optional<std::size_t> single = results.with_robots(i, 1);
    if (cell.robots == 1 || !single) {
      continue;
    }
    const auto ratio = ratio_estimate(values(results.sample(i, kDeathDistance)),
                                      values(results.sample(*single, kDeathDistance)));
    if (ratio) {
      table.rows.push_back(cell_heads(cell, results.count(i)));
      table.rows.back().emplace_back(scaled(*ratio, 1.0 / static_cast<double>(cell.robots)));
    }
  }
  return table;
}

/// The pairwise differences between the values of one factor.
class Comparison {
 public:
  Comparison(const Battery& battery, const Results& results, const Factor& factor)
      : battery_(battery), results_(results), factor_(factor) {}

  Table table() {
    Table table{battery_.config().name + ": differences between values of " + factor_.path +
                    " on the same seeds, p after Holm",
                columns(),
                {}};
    for (const std::string& measure : battery_.config().measures) {
      for (std::size_t i = 0; i < battery_.cells().size(); ++i) {
        compare(i, measure, table);
      }
    }
    const std::vector<double> corrected = holm_corrected(p_values_);
    for (std::size_t row = 0; row < table.rows.size(); ++row) {
      table.rows[row].emplace_back(corrected[row]);
    }
    return table;
  }

 private:
  std::vector<Column> columns() const {
    std::vector<Column> columns{{"measure", "measure"}};
    for (const Factor& factor : battery_.factors()) {
      if (factor.path != factor_.path) {
        columns.push_back({short_name(factor.path), short_name(factor.path)});
      }
    }
    columns.insert(columns.end(), {{"robots", "robots"},
                                   {"pairs", "pairs"},
                                   {"values", "difference of"},
                                   {"difference", "difference", 2, true},
                                   {"p_holm", "p", 4}});
    return columns;
  }

  /// Rows for `cell` against every cell with a later value of the factor.
  void compare(std::size_t cell, const std::string& measure, Table& table) {
    const Cell& a = battery_.cells()[cell];
    const std::string& mine = level(a);
    const auto own = std::find(factor_.values.begin(), factor_.values.end(), mine);
    for (auto other = own + 1; other < factor_.values.end(); ++other) {
      if (const auto b = results_.find(with_level(a, *other), a.robots)) {
        add(cell, *b, measure, table);
      }
    }
  }

  void add(std::size_t a, std::size_t b, const std::string& measure, Table& table) {
    const auto [left, right] = paired(results_.sample(b, measure), results_.sample(a, measure));
    const std::optional<Difference> difference = paired_difference(left, right);
    if (!difference) {
      return;
    }
    const Cell& first = battery_.cells()[a];
    std::vector<TableCell> row{measure};
    for (const Setting& setting : first.levels) {
      if (setting.path != factor_.path) {
        row.emplace_back(setting.value);
      }
    }
    row.emplace_back(first.robots);
    row.emplace_back(static_cast<std::int64_t>(left.size()));
    row.emplace_back(level(battery_.cells()[b]) + " - " + level(first));
    row.emplace_back(difference->estimate);
    table.rows.push_back(std::move(row));
    p_values_.push_back(difference->p_value);
  }

  [[nodiscard]] const std::string& level(const Cell& cell) const {
    return std::find_if(cell.levels.begin(), cell.levels.end(),
                        [this](const Setting& s) { return s.path == factor_.path; })
        ->value;
  }

  [[nodiscard]] std::vector<Setting> with_level(const Cell& cell, const std::string& value) const {
    std::vector<Setting> levels = cell.levels;
    for (Setting& setting : levels) {
      if (setting.path == factor_.path) {
        setting.value = value;
      }
    }
    return levels;
  }

  const Battery& battery_;
  const Results& results_;
  const Factor& factor_;
  std::vector<double> p_values_;
};

}  // namespace

std::vector<ReportTable> summarize(const Battery& battery, const RunStore& store) {
  const Results results(battery, store);
  std::vector<ReportTable> tables{{"cells", cells_table(battery, results)}};
  Table improvement = improvement_table(battery, results);
  if (!improvement.rows.empty()) {
    tables.push_back({"improvement", std::move(improvement)});
  }
  for (const Factor& factor : battery.factors()) {
    if (factor.path == battery.config().compare) {
      tables.push_back({"comparison", Comparison(battery, results, factor).table()});
    }
  }
  return tables;
}

}  // namespace tacit
