#include "console/report/metrics_table.h"

namespace tacit {
namespace {

struct ToCell {
  TableCell operator()(std::uint64_t count) const { return static_cast<std::int64_t>(count); }
  TableCell operator()(double measure) const { return measure; }
};

TableCell cell_of(const Metric& metric) {
  return metric.value ? std::visit(ToCell{}, *metric.value) : TableCell{};
}

}  // namespace

Table metrics_table(const Tally& tally) {
  Table table;
  table.columns = {{"metric", "metric", 0, false},
                   {"value", "value", 2, false},
                   {"unit", "unit", 0, false},
                   {"meaning", "meaning", 0, false}};
  for (const Metric& metric : tally.metrics()) {
    table.rows.push_back({std::string(metric.key), cell_of(metric), std::string(metric.unit),
                          std::string(metric.doc)});
  }
  return table;
}

}  // namespace tacit
