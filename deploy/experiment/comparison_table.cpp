#include "deploy/experiment/comparison_table.h"

#include <algorithm>
#include <optional>

#include "console/report/holm.h"

namespace tacit {
namespace {

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
    const auto own = std::find(factor_.values.begin(), factor_.values.end(), level(a));
    for (auto other = own; other != factor_.values.end(); ++other) {
      if (other == own) {
        continue;
      }
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
    for (const Factor& factor : battery_.factors()) {
      if (factor.path != factor_.path) {
        row.push_back(cell_of(first.level(factor.path)));
      }
    }
    row.emplace_back(first.robots);
    row.emplace_back(static_cast<std::int64_t>(left.size()));
    row.emplace_back(level(battery_.cells()[b]) + " - " + level(first));
    row.emplace_back(difference->estimate);
    table.rows.push_back(std::move(row));
    p_values_.push_back(difference->p_value);
  }

  [[nodiscard]] std::string level(const Cell& cell) const { return cell.level(factor_.path); }

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

Table comparison_table(const Battery& battery, const Results& results, const Factor& factor) {
  return Comparison(battery, results, factor).table();
}

}  // namespace tacit
