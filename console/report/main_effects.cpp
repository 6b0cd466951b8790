#include "console/report/main_effects.h"

#include <algorithm>
#include <boost/math/distributions/fisher_f.hpp>
#include <map>

namespace tacit {
namespace {

struct Sum {
  double values = 0.0;
  double count = 0.0;
  void add(double value) {
    values += value;
    count += 1.0;
  }
  [[nodiscard]] double mean() const { return values / count; }
};

struct Squares {
  double sum = 0.0;
  std::size_t degrees = 0;
};

double grand_mean(std::span<const Observation> observations) {
  Sum all;
  for (const Observation& each : observations) {
    all.add(each.value);
  }
  return all.mean();
}

Squares total_squares(std::span<const Observation> observations, double centre) {
  Squares total{0.0, observations.size() - 1};
  for (const Observation& each : observations) {
    total.sum += (each.value - centre) * (each.value - centre);
  }
  return total;
}

Squares factor_squares(std::span<const Observation> observations, std::size_t factor,
                       double centre) {
  std::map<std::size_t, Sum> by_level;
  for (const Observation& each : observations) {
    by_level[each.levels.at(factor)].add(each.value);
  }
  Squares squares{0.0, by_level.size() - 1};
  for (const auto& [level, sum] : by_level) {
    squares.sum += sum.count * (sum.mean() - centre) * (sum.mean() - centre);
  }
  return squares;
}

MainEffect effect_of(const Squares& squares, double total) {
  MainEffect effect{squares.sum / total, squares.degrees, 0.0, std::nullopt, std::nullopt};
  if (squares.degrees > 0) {
    effect.mean_square = squares.sum / static_cast<double>(squares.degrees);
  }
  return effect;
}

void test(MainEffect& effect, const MainEffect& residual) {
  if (effect.degrees == 0 || residual.mean_square <= 0.0) {
    return;
  }
  effect.f = effect.mean_square / residual.mean_square;
  const boost::math::fisher_f distribution(static_cast<double>(effect.degrees),
                                           static_cast<double>(residual.degrees));
  effect.p_value = boost::math::cdf(boost::math::complement(distribution, *effect.f));
}

}  // namespace

std::vector<MainEffect> main_effects(std::span<const Observation> observations) {
  if (observations.empty()) {
    return {};
  }
  const double centre = grand_mean(observations);
  const Squares total = total_squares(observations, centre);
  std::vector<MainEffect> effects;
  Squares rest = total;
  for (std::size_t i = 0; i < observations.front().levels.size(); ++i) {
    const Squares squares = factor_squares(observations, i, centre);
    effects.push_back(effect_of(squares, total.sum));
    rest.sum = std::max(0.0, rest.sum - squares.sum);
    rest.degrees -= std::min(rest.degrees, squares.degrees);
  }
  if (total.sum <= 0.0 || rest.degrees == 0) {
    return {};
  }
  const MainEffect residual = effect_of(rest, total.sum);
  for (MainEffect& effect : effects) {
    test(effect, residual);
  }
  effects.push_back(residual);
  return effects;
}

}  // namespace tacit
