#include "deploy/experiment/held_out_table.h"

#include <optional>
#include <utility>

#include "console/report/holm.h"
#include "console/report/wilcoxon.h"
#include "deploy/experiment/results.h"
#include "deploy/experiment/selection.h"

namespace tacit {
namespace {

std::string settings_text(const Cell& cell) {
  std::string text;
  for (const Setting& level : cell.levels_but("scenario")) {
    text += (text.empty() ? "" : ", ") + short_name(level.path) + " = " + level.value;
  }
  return text;
}

std::vector<Column> columns() {
  return {{"scenario", "scenario"},
          {"robots", "robots"},
          {"rival", "rival"},
          {"selected", "selected"},
          {"pairs", "pairs"},
          {"training_mean", "selected in training", 1},
          {"selected_mean", "selected", 1, true},
          {"rival_mean", "rival", 1, true},
          {"difference", "difference", 1, true},
          {"d_z", "d_z", 3},
          {"p_t", "p (t)", 4},
          {"p_wilcoxon", "p (Wilcoxon)", 4},
          {"p_t_holm", "p (t, Holm)", 4},
          {"p_wilcoxon_holm", "p (Wilcoxon, Holm)", 4}};
}

class HeldOut {
 public:
  HeldOut(const Battery& battery, const RunStore& store)
      : battery_(battery),
        store_(store),
        training_(battery, store),
        held_out_(battery, store, held_out_runs(battery, store)) {}

  Table table() {
    table_.title = battery_.config().name + ": " + battery_.config().select_by +
                   " of what was selected in training, on held-out seeds";
    table_.columns = columns();
    for (const Contest& contest : contests(battery_)) {
      if (const std::optional<std::size_t> best = winner(battery_, store_, contest)) {
        for (const std::size_t rival : contest.rivals) {
          add(*best, rival);
        }
      }
    }
    append_holm(p_t_);
    append_holm(p_wilcoxon_);
    return std::move(table_);
  }

 private:
  void add(std::size_t best, std::size_t rival) {
    const std::string& measure = battery_.config().select_by;
    const Sample selected = held_out_.sample(best, measure);
    const Sample other = held_out_.sample(rival, measure);
    const auto [a, b] = paired(selected, other);
    const std::optional<Difference> difference = paired_difference(a, b);
    const Cell& cell = battery_.cells()[best];
    p_t_.push_back(difference ? std::optional(difference->p_value) : std::nullopt);
    p_wilcoxon_.push_back(wilcoxon_signed_rank(a, b));
    table_.rows.push_back(
        {battery_.scenario_name(cell), cell.robots, battery_.cells()[rival].level("variant"),
         settings_text(cell), static_cast<std::int64_t>(a.size()),
         cell_of(mean(values(training_.sample(best, measure)))),
         cell_of(mean_estimate(values(selected))), cell_of(mean_estimate(values(other))),
         difference ? TableCell{difference->estimate} : TableCell{}, cell_of(paired_effect(a, b)),
         cell_of(p_t_.back()), cell_of(p_wilcoxon_.back())});
  }

  /// A column of p-values after Holm; a test that could not be made is none of the family.
  void append_holm(const std::vector<std::optional<double>>& p_values) {
    std::vector<double> made;
    for (const std::optional<double>& p : p_values) {
      if (p) {
        made.push_back(*p);
      }
    }
    const std::vector<double> corrected = holm_corrected(made);
    std::size_t next = 0;
    for (std::size_t row = 0; row < p_values.size(); ++row) {
      table_.rows[row].push_back(p_values[row] ? TableCell{corrected[next++]} : TableCell{});
    }
  }

  const Battery& battery_;
  const RunStore& store_;
  Results training_;
  Results held_out_;
  Table table_;
  std::vector<std::optional<double>> p_t_;
  std::vector<std::optional<double>> p_wilcoxon_;
};

}  // namespace

Table held_out_table(const Battery& battery, const RunStore& store) {
  return HeldOut(battery, store).table();
}

}  // namespace tacit
