#include "deploy/experiment/variant_tables.h"

#include <algorithm>
#include <array>
#include <optional>

#include "console/report/holm.h"
#include "console/report/main_effects.h"

namespace tacit {
namespace {

/// Values of two variants side by side.
using Pairs = std::pair<std::vector<double>, std::vector<double>>;

std::optional<std::size_t> counterpart(const Results& results, const Cell& cell,
                                       const std::string& variant) {
  std::vector<Setting> levels = cell.levels;
  for (Setting& level : levels) {
    level.value = level.path == "variant" ? variant : level.value;
  }
  return results.find(levels, cell.robots);
}

Pairs pairs_of(const Battery& battery, const Results& results, const Group& a, const Group& b) {
  const std::string& measure = battery.config().measures.front();
  Pairs pairs;
  for (const std::size_t cell : a.cells) {
    const auto other = counterpart(results, battery.cells()[cell], b.name);
    if (!other) {
      continue;
    }
    const auto [left, right] =
        paired(results.sample(cell, measure), results.sample(*other, measure));
    pairs.first.insert(pairs.first.end(), left.begin(), left.end());
    pairs.second.insert(pairs.second.end(), right.begin(), right.end());
  }
  return pairs;
}

void append_holm(Table& table, const std::vector<double>& p_values) {
  const std::vector<double> corrected = holm_corrected(p_values);
  for (std::size_t i = 0; i < table.rows.size(); ++i) {
    table.rows[i].emplace_back(corrected[i]);
  }
}

std::size_t index_in(const std::vector<std::string>& names, const std::string& name) {
  return static_cast<std::size_t>(std::find(names.begin(), names.end(), name) - names.begin());
}

/// Team size, variant and scenario of every run, by numbers.
std::vector<Observation> observations(const Battery& battery, const Results& results) {
  const std::vector<std::string> scenarios = scenario_names(battery.config());
  const std::vector<Group> variants = by_variant(battery);
  std::vector<Observation> all;
  for (std::size_t v = 0; v < variants.size(); ++v) {
    for (const std::size_t i : variants[v].cells) {
      const Cell& cell = battery.cells()[i];
      const std::size_t scenario = index_in(scenarios, battery.scenario_name(cell));
      for (const double value : values(results.sample(i, battery.config().measures.front()))) {
        all.push_back({value, {static_cast<std::size_t>(cell.robots), v, scenario}});
      }
    }
  }
  return all;
}

constexpr std::array<const char*, 3> kEffects{"robots", "variant", "scenario"};

void add_effect(Table& table, const std::string& name, const MainEffect& effect) {
  table.rows.push_back({name, effect.eta_squared, static_cast<std::int64_t>(effect.degrees),
                        cell_of(effect.f), cell_of(effect.p_value)});
}

}  // namespace

Table variants_table(const Battery& battery, const Results& results) {
  Table table{battery.config().name + ": differences of " + battery.config().measures.front() +
                  " between variants, paired by all else; p after Holm",
              {{"values", "difference of"},
               {"pairs", "pairs"},
               {"difference", "difference", 2, true},
               {"d_z", "d_z", 3},
               {"p", "p", 4},
               {"p_holm", "p after Holm", 4}},
              {}};
  std::vector<double> p_values;
  const std::vector<Group> variants = by_variant(battery);
  for (std::size_t a = 0; a < variants.size(); ++a) {
    for (std::size_t b = a + 1; b < variants.size(); ++b) {
      const auto [first, second] = pairs_of(battery, results, variants[a], variants[b]);
      if (const auto difference = paired_difference(second, first)) {
        table.rows.push_back({variants[b].name + " - " + variants[a].name,
                              static_cast<std::int64_t>(first.size()), difference->estimate,
                              cell_of(paired_effect(second, first)), difference->p_value});
        p_values.push_back(difference->p_value);
      }
    }
  }
  append_holm(table, p_values);
  return table;
}

Table effects_table(const Battery& battery, const Results& results) {
  Table table{battery.config().name + ": shares of the variation of " +
                  battery.config().measures.front() + " (main effects)",
              {{"effect", "effect"},
               {"eta_squared", "η²", 4},
               {"degrees", "df"},
               {"f", "F", 2},
               {"p", "p", 4}},
              {}};
  const std::vector<MainEffect> effects = main_effects(observations(battery, results));
  for (std::size_t i = 0; i < kEffects.size() && i < effects.size(); ++i) {
    if (effects[i].degrees > 0) {
      add_effect(table, kEffects[i], effects[i]);
    }
  }
  if (!effects.empty()) {
    add_effect(table, "residual", effects.back());
  }
  return table;
}

}  // namespace tacit
