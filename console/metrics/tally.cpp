#include "console/metrics/tally.h"

namespace tacit {

void Tally::add(const Event& event) {
  std::apply([&](auto&... fold) { (fold.add(event), ...); }, folds_);
}

std::vector<Metric> Tally::metrics() const {
  std::vector<Metric> all;
  const auto append = [&](const std::vector<Metric>& some) {
    all.insert(all.end(), some.begin(), some.end());
  };
  std::apply([&](const auto&... fold) { (append(fold.metrics()), ...); }, folds_);
  return all;
}

std::optional<double> Tally::value(std::string_view key) const {
  for (const Metric& metric : metrics()) {
    if (metric.key == key && metric.value) {
      return std::visit([](auto number) { return static_cast<double>(number); }, *metric.value);
    }
  }
  return std::nullopt;
}

}  // namespace tacit
