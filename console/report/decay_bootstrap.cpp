#include "console/report/decay_bootstrap.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "idl/types/random.h"

namespace tacit {
namespace {

using Blocks = std::vector<std::vector<FitCell>>;

Blocks by_block(std::span<const FitCell> cells) {
  std::map<std::size_t, std::vector<FitCell>> sorted;
  for (const FitCell& cell : cells) {
    sorted[cell.block].push_back(cell);
  }
  Blocks blocks;
  for (auto& [block, its] : sorted) {
    blocks.push_back(std::move(its));
  }
  return blocks;
}

std::vector<double> drawn(const std::vector<double>& values, Stream& chance) {
  std::vector<double> sample(values.size());
  for (double& value : sample) {
    value = values[chance.below(values.size())];
  }
  return sample;
}

std::vector<FitCell> drawn(const Blocks& blocks, Stream& chance) {
  std::vector<FitCell> sample;
  for (std::size_t i = 0; i < blocks.size(); ++i) {
    for (const FitCell& cell : blocks[chance.below(blocks.size())]) {
      sample.push_back({cell.x, i, drawn(cell.values, chance)});
    }
  }
  return sample;
}

/// `value` between the 2.5th and the 97.5th percentile of `samples`.
Estimate estimate(std::vector<double> samples, double value) {
  if (samples.empty()) {
    return {value, value, value};
  }
  std::sort(samples.begin(), samples.end());
  const auto at = [&samples](double share) {
    return samples[static_cast<std::size_t>(
        std::lround(share * static_cast<double>(samples.size() - 1)))];
  };
  return {value, at(0.025), at(0.975)};
}

template <class Figure>
Estimate estimate(const std::vector<Decay>& curves, double value, const Figure& figure) {
  std::vector<double> samples;
  for (const Decay& curve : curves) {
    samples.push_back(figure(curve));
  }
  return estimate(std::move(samples), value);
}

}  // namespace

DecayBootstrap::DecayBootstrap(std::span<const FitCell> cells, std::uint64_t seed,
                               std::size_t samples) {
  const Blocks blocks = by_block(cells);
  Stream chance(seed, "decay bootstrap");
  for (std::size_t i = 0; i < samples && !blocks.empty(); ++i) {
    if (const auto curve = decay_curve(drawn(blocks, chance))) {
      curves_.push_back(*curve);
    }
  }
}

Estimate DecayBootstrap::a(double value) const {
  return estimate(curves_, value, [](const Decay& curve) { return curve.a; });
}

Estimate DecayBootstrap::b(double value) const {
  return estimate(curves_, value, [](const Decay& curve) { return curve.b; });
}

Estimate DecayBootstrap::c(double value) const {
  return estimate(curves_, value, [](const Decay& curve) { return curve.c; });
}

Estimate DecayBootstrap::at(double x, double value) const {
  return estimate(curves_, value, [x](const Decay& curve) { return curve.at(x); });
}

}  // namespace tacit
