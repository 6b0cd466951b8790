#include "deploy/experiment/summary.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "console/report/chart.h"
#include "console/report/estimate.h"
#include "deploy/experiment/comparison_table.h"
#include "deploy/experiment/held_out_table.h"
#include "deploy/experiment/learning_curve.h"
#include "deploy/experiment/results.h"
#include "deploy/experiment/team_size.h"
#include "deploy/experiment/variant_tables.h"

namespace tacit {
namespace {

constexpr const char* kDeathDistance = "mean_death_distance_m";
constexpr const char* kFailed = "failed";

std::vector<Column> cell_columns(const Battery& battery) {
  std::vector<Column> columns;
  for (const Factor& factor : battery.factors()) {
    columns.push_back({short_name(factor.path), short_name(factor.path)});
  }
  columns.push_back({"robots", "robots"});
  columns.push_back({"runs", "runs"});
  return columns;
}

std::vector<TableCell> cell_heads(const Battery& battery, const Cell& cell, std::size_t runs) {
  std::vector<TableCell> heads;
  for (const Factor& factor : battery.factors()) {
    heads.push_back(cell_of(cell.level(factor.path)));
  }
  heads.emplace_back(cell.robots);
  heads.emplace_back(static_cast<std::int64_t>(runs));
  return heads;
}

/// Of chains also how often they failed, for a mean score hides it.
std::vector<std::string> measures(const Battery& battery) {
  std::vector<std::string> all = battery.config().measures;
  const bool there = std::find(all.begin(), all.end(), kFailed) != all.end();
  if (battery.config().episodes > 1 && !there) {
    all.emplace_back(kFailed);
  }
  return all;
}

Table cells_table(const Battery& battery, const Results& results) {
  Table table{battery.config().name + ": means with 95 % intervals", cell_columns(battery), {}};
  for (const std::string& measure : measures(battery)) {
    table.columns.push_back({measure, measure, 2, true});
  }
  for (std::size_t i = 0; i < battery.cells().size(); ++i) {
    table.rows.push_back(cell_heads(battery, battery.cells()[i], results.count(i)));
    for (const std::string& measure : measures(battery)) {
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
    const std::optional<std::size_t> single = results.find(cell.levels, 1);
    if (cell.robots == 1 || !single) {
      continue;
    }
    const auto ratio = ratio_estimate(values(results.sample(i, kDeathDistance)),
                                      values(results.sample(*single, kDeathDistance)));
    if (ratio) {
      table.rows.push_back(cell_heads(battery, cell, results.count(i)));
      table.rows.back().emplace_back(scaled(*ratio, 1.0 / static_cast<double>(cell.robots)));
    }
  }
  return table;
}

/// The tables, of which those without a row are left out.
class Tables {
 public:
  void add(const char* name, Table table) {
    if (!table.rows.empty()) {
      tables_.push_back({name, std::move(table)});
    }
  }
  std::vector<ReportTable> take() { return std::move(tables_); }

 private:
  std::vector<ReportTable> tables_;
};

/// A chart without a point is no figure.
void add(std::vector<ReportFigure>& figures, const char* name, const Chart& chart) {
  const bool drawn = std::any_of(chart.series.begin(), chart.series.end(),
                                 [](const ChartSeries& series) { return !series.points.empty(); });
  if (drawn) {
    figures.push_back({name, to_svg(chart)});
  }
}

}  // namespace

std::vector<ReportTable> summarize(const Battery& battery, const RunStore& store) {
  const Results results(battery, store);
  Tables tables;
  tables.add("cells", cells_table(battery, results));
  tables.add("improvement", improvement_table(battery, results));
  for (const Factor& factor : battery.factors()) {
    if (factor.path == battery.config().compare) {
      tables.add("comparison", comparison_table(battery, results, factor));
    }
  }
  if (TeamSizeStudy::applies(battery)) {
    const TeamSizeStudy study(battery, results);
    tables.add("team_size", study.sizes());
    tables.add("fit", study.fits());
    tables.add("fit_band", study.bands());
  }
  if (by_variant(battery).size() > 1 && !battery.config().measures.empty()) {
    tables.add("variants", variants_table(battery, results));
    tables.add("effects", effects_table(battery, results));
  }
  if (battery.config().episodes > 1) {
    const LearningCurve curve(battery, results);
    tables.add("curve", curve.episodes());
    tables.add("learned", curve.learned());
  }
  if (!battery.config().select_by.empty()) {
    tables.add("held_out", held_out_table(battery, store));
  }
  return tables.take();
}

std::vector<ReportFigure> draw(const Battery& battery, const RunStore& store) {
  const Results results(battery, store);
  std::vector<ReportFigure> figures;
  if (TeamSizeStudy::applies(battery)) {
    add(figures, "team_size", TeamSizeStudy(battery, results).chart());
  }
  if (battery.config().episodes > 1) {
    add(figures, "curve", LearningCurve(battery, results).chart());
  }
  return figures;
}

}  // namespace tacit
