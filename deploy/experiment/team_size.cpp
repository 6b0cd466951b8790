#include "deploy/experiment/team_size.h"

#include <algorithm>
#include <utility>

namespace tacit {
namespace {

constexpr std::uint64_t kBootstrapSeed = 1;

std::vector<FitCell> fit_cells(const Battery& battery, const Results& results, const Group& group,
                               const std::string& measure) {
  std::vector<FitCell> cells;
  const std::vector<std::string> scenarios = scenario_names(battery.config());
  for (const std::size_t i : group.cells) {
    const Cell& cell = battery.cells()[i];
    const auto scenario =
        std::find(scenarios.begin(), scenarios.end(), battery.scenario_name(cell));
    FitCell one{static_cast<double>(cell.robots),
                static_cast<std::size_t>(scenario - scenarios.begin()),
                values(results.sample(i, measure))};
    if (!one.values.empty()) {
      cells.push_back(std::move(one));
    }
  }
  return cells;
}

std::string best_model(const DecayFit& fit) {
  if (fit.aic < fit.aic_line && fit.aic < fit.aic_constant) {
    return "decay";
  }
  return fit.aic_line < fit.aic_constant ? "line" : "constant";
}

}  // namespace

bool TeamSizeStudy::applies(const Battery& battery) {
  return team_sizes(battery).size() > 1 && battery.config().factors.empty() &&
         !battery.config().measures.empty();
}

TeamSizeStudy::TeamSizeStudy(const Battery& battery, const Results& results)
    : battery_(battery),
      results_(results),
      measure_(battery.config().measures.front()),
      variants_(by_variant(battery)),
      groups_(variants_) {
  if (variants_.size() > 1) {
    groups_.push_back(all_variants(battery));
  }
  for (const Group& group : groups_) {
    fit(group);
  }
}

void TeamSizeStudy::fit(const Group& group) {
  const std::vector<FitCell> cells = fit_cells(battery_, results_, group, measure_);
  if (const std::optional<DecayFit> found = fit_decay(cells)) {
    fitted_.push_back({group, *found, DecayBootstrap(cells, kBootstrapSeed)});
  }
}

std::vector<double> TeamSizeStudy::variant_means(std::int64_t robots) const {
  std::vector<double> means;
  for (const Group& variant : variants_) {
    if (const auto one = mean(values(results_, with_robots(battery_, variant, robots), measure_))) {
      means.push_back(*one);
    }
  }
  return means;
}

Table TeamSizeStudy::sizes() const {
  Table table{battery_.config().name + ": " + measure_ + " by team size, over scenarios and seeds",
              {{"variant", "variant"},
               {"robots", "robots"},
               {"runs", "runs"},
               {"mean", "mean", 2},
               {"sd", "standard deviation", 2},
               {"lowest", "lowest variant", 2},
               {"highest", "highest variant", 2}},
              {}};
  for (const Group& group : groups_) {
    add_sizes(table, group);
  }
  return table;
}

void TeamSizeStudy::add_sizes(Table& table, const Group& group) const {
  const bool over_all = variants_.size() > 1 && group.name == groups_.back().name;
  for (const std::int64_t robots : team_sizes(battery_)) {
    const std::vector<double> all =
        values(results_, with_robots(battery_, group, robots), measure_);
    std::vector<TableCell> row{cell_of(group.name), robots, static_cast<std::int64_t>(all.size()),
                               cell_of(mean(all)), cell_of(standard_deviation(all))};
    const std::vector<double> means = over_all ? variant_means(robots) : std::vector<double>{};
    if (means.empty()) {
      row.insert(row.end(), 2, TableCell{});
    } else {
      row.emplace_back(*std::min_element(means.begin(), means.end()));
      row.emplace_back(*std::max_element(means.begin(), means.end()));
    }
    table.rows.push_back(std::move(row));
  }
}

Table TeamSizeStudy::fits() const {
  Table table{battery_.config().name + ": " + measure_ +
                  " as a e^(-b n) + c of the team size n; 95 % intervals by bootstrap",
              {{"variant", "variant"},
               {"a", "a", 1, true},
               {"b", "b", 4, true},
               {"c", "c", 1, true},
               {"r_squared", "R²", 3},
               {"aic_decay", "AIC decay", 1},
               {"aic_line", "AIC line", 1},
               {"aic_constant", "AIC constant", 1},
               {"best", "best"}},
              {}};
  for (const Fitted& each : fitted_) {
    const Decay& curve = each.fit.curve;
    table.rows.push_back({cell_of(each.group.name), each.samples.a(curve.a),
                          each.samples.b(curve.b), each.samples.c(curve.c), each.fit.r_squared,
                          each.fit.aic, each.fit.aic_line, each.fit.aic_constant,
                          best_model(each.fit)});
  }
  return table;
}

Table TeamSizeStudy::bands() const {
  Table table{battery_.config().name + ": " + measure_ + " measured and fitted",
              {{"variant", "variant"},
               {"robots", "robots"},
               {"measured", "measured", 2},
               {"fitted", "fitted", 2, true}},
              {}};
  for (const Fitted& each : fitted_) {
    for (const std::int64_t robots : team_sizes(battery_)) {
      const auto n = static_cast<double>(robots);
      const auto all = values(results_, with_robots(battery_, each.group, robots), measure_);
      table.rows.push_back({cell_of(each.group.name), robots, cell_of(mean(all)),
                            each.samples.at(n, each.fit.curve.at(n))});
    }
  }
  return table;
}

ChartSeries TeamSizeStudy::measured_series(const Group& group) const {
  ChartSeries series{group.name.empty() ? "measured" : group.name, ChartSeries::Style::Marks, {}};
  const bool over_all = variants_.size() > 1 && group.name == groups_.back().name;
  for (const std::int64_t robots : team_sizes(battery_)) {
    const auto all = values(results_, with_robots(battery_, group, robots), measure_);
    const std::optional<double> centre = mean(all);
    if (!centre) {
      continue;
    }
    Estimate bar{*centre, *centre, *centre};
    if (over_all) {
      const std::vector<double> means = variant_means(robots);
      bar.low = *std::min_element(means.begin(), means.end());
      bar.high = *std::max_element(means.begin(), means.end());
    } else if (variants_.size() == 1) {
      bar = mean_estimate(all).value_or(bar);
    }
    series.points.push_back({static_cast<double>(robots), bar});
  }
  return series;
}

ChartSeries TeamSizeStudy::curve_series(const Fitted& fitted) const {
  constexpr int kSteps = 60;
  ChartSeries series{"a e^(-b n) + c", ChartSeries::Style::Curve, {}};
  const std::vector<std::int64_t> sizes = team_sizes(battery_);
  const auto first = static_cast<double>(sizes.front());
  const auto last = static_cast<double>(sizes.back());
  for (int i = 0; i <= kSteps; ++i) {
    const double n = first + (last - first) * i / kSteps;
    series.points.push_back({n, fitted.samples.at(n, fitted.fit.curve.at(n))});
  }
  return series;
}

Chart TeamSizeStudy::chart() const {
  Chart chart{battery_.config().name + ": " + measure_ + " by team size",
              "robots",
              measure_,
              ChartAxis::Scale::Linear,
              {}};
  // All variants together first, in the darkest colour.
  chart.series.push_back(measured_series(groups_.back()));
  if (!fitted_.empty() && fitted_.back().group.name == groups_.back().name) {
    chart.series.push_back(curve_series(fitted_.back()));
  }
  for (std::size_t i = 0; variants_.size() > 1 && i < variants_.size(); ++i) {
    chart.series.push_back(measured_series(variants_[i]));
  }
  chart.y_scale = fitting_scale(chart.series);
  return chart;
}

}  // namespace tacit
