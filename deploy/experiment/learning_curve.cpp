#include "deploy/experiment/learning_curve.h"

#include <optional>
#include <utility>

#include "console/report/holm.h"

namespace tacit {
namespace {

std::string score_of(std::int64_t episode) { return "score_ticks_" + std::to_string(episode); }

std::int64_t robots_of(const Battery& battery, const Group& group) {
  return battery.cells()[group.cells.front()].robots;
}

}  // namespace

std::vector<Group> LearningCurve::groups() const {
  std::vector<Group> kinds = by_variant(battery_);
  const std::vector<Group> rivals = by_rival(battery_);
  kinds.insert(kinds.end(), rivals.begin(), rivals.end());
  std::vector<Group> groups;
  for (const Group& kind : kinds) {
    for (const std::int64_t robots : team_sizes(battery_)) {
      groups.push_back(with_robots(battery_, kind, robots));
    }
  }
  return groups;
}

std::vector<double> LearningCurve::scores(const Group& group, std::int64_t episode) const {
  return values(results_, group, score_of(episode));
}

std::vector<double> LearningCurve::stretch(const Group& group, std::int64_t first) const {
  const std::int64_t count = evaluated(battery_.config());
  std::vector<double> sums = scores(group, first);
  for (std::int64_t episode = first + 1; episode < first + count; ++episode) {
    const std::vector<double> more = scores(group, episode);
    for (std::size_t i = 0; i < sums.size() && i < more.size(); ++i) {
      sums[i] += more[i];
    }
  }
  for (double& sum : sums) {
    sum /= static_cast<double>(count);
  }
  return sums;
}

Table LearningCurve::episodes() const {
  Table table{battery_.config().name + ": score_ticks from run to run, means with 95 % intervals",
              {{"variant", "variant"},
               {"robots", "robots"},
               {"episode", "run"},
               {"chains", "chains"},
               {"score_ticks", "score_ticks", 1, true}},
              {}};
  for (const Group& group : groups()) {
    for (std::int64_t episode = 1; episode <= battery_.config().episodes; ++episode) {
      const std::vector<double> all = scores(group, episode);
      if (!all.empty()) {
        table.rows.push_back({cell_of(group.name), robots_of(battery_, group), episode,
                              static_cast<std::int64_t>(all.size()), cell_of(mean_estimate(all))});
      }
    }
  }
  return table;
}

Table LearningCurve::learned() const {
  Table table{battery_.config().name + ": score_ticks of the last " +
                  std::to_string(evaluated(battery_.config())) +
                  " runs less that of as many first, p after Holm",
              {{"variant", "variant"},
               {"robots", "robots"},
               {"chains", "chains"},
               {"first", "first", 1, true},
               {"last", "last", 1, true},
               {"difference", "difference", 1, true},
               {"d_z", "d_z", 3},
               {"p", "p", 4},
               {"p_holm", "p after Holm", 4}},
              {}};
  std::vector<double> p_values;
  for (const Group& group : groups()) {
    add_learned(table, group, p_values);
  }
  const std::vector<double> corrected = holm_corrected(p_values);
  for (std::size_t i = 0; i < table.rows.size(); ++i) {
    table.rows[i].emplace_back(corrected[i]);
  }
  return table;
}

void LearningCurve::add_learned(Table& table, const Group& group,
                                std::vector<double>& p_values) const {
  const std::vector<double> first = stretch(group, 1);
  const std::vector<double> last =
      stretch(group, battery_.config().episodes - evaluated(battery_.config()) + 1);
  const std::optional<Difference> difference = paired_difference(last, first);
  if (!difference) {
    return;
  }
  table.rows.push_back({cell_of(group.name), robots_of(battery_, group),
                        static_cast<std::int64_t>(first.size()), cell_of(mean_estimate(first)),
                        cell_of(mean_estimate(last)), difference->estimate,
                        cell_of(paired_effect(last, first)), difference->p_value});
  p_values.push_back(difference->p_value);
}

ChartSeries LearningCurve::series(const Group& group) const {
  ChartSeries series{group.name, ChartSeries::Style::Curve, {}};
  for (std::int64_t episode = 1; episode <= battery_.config().episodes; ++episode) {
    const std::vector<double> all = scores(group, episode);
    if (const std::optional<double> centre = mean(all)) {
      const Estimate point = mean_estimate(all).value_or(Estimate{*centre, *centre, *centre});
      series.points.push_back({static_cast<double>(episode), point});
    }
  }
  return series;
}

Chart LearningCurve::chart() const {
  Chart chart{battery_.config().name + ": score from run to run",
              "run",
              "score_ticks",
              ChartAxis::Scale::Linear,
              {}};
  const std::vector<std::int64_t> sizes = team_sizes(battery_);
  if (sizes.size() > 1) {
    for (const std::int64_t robots : sizes) {
      Group group = with_robots(battery_, all_variants(battery_), robots);
      group.name = std::to_string(robots) + " robots";
      chart.series.push_back(series(group));
    }
  } else {
    for (Group& group : groups()) {
      group.name = group.name.empty() ? "mean" : group.name;
      chart.series.push_back(series(group));
    }
  }
  chart.y_scale = fitting_scale(chart.series);
  return chart;
}

}  // namespace tacit
