#include "console/metrics/tally.h"

#include <type_traits>

namespace tacit {
namespace {

/// What attacks a target has no meaning where there is none.
template <class Fold>
constexpr bool kOnlyOfGuards =
    std::is_same_v<Fold, Enemies> || std::is_same_v<Fold, DeathDistance> ||
    std::is_same_v<Fold, Decoys> || std::is_same_v<Fold, IdleSpread>;

}  // namespace

void Tally::add(const Event& event) {
  std::apply([&](auto&... fold) { (fold.add(event), ...); }, folds_);
}

std::vector<Metric> Tally::metrics() const {
  std::vector<Metric> all;
  const bool guard = !of<Operation>().team.has_value() && !of<Forage>().mines.has_value();
  const auto append = [&]<class Fold>(const Fold& fold) {
    if (guard || !kOnlyOfGuards<Fold>) {
      const std::vector<Metric> some = fold.metrics();
      all.insert(all.end(), some.begin(), some.end());
    }
  };
  std::apply([&](const auto&... fold) { (append(fold), ...); }, folds_);
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
