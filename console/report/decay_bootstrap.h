#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "console/report/decay_fit.h"
#include "console/report/estimate.h"

namespace tacit {

/// Where the curve would lie in other such experiments: fits to samples drawn anew, with
/// replacement, from the blocks and, within each of their cells, from its values (Efron 1979).
class DecayBootstrap {
 public:
  /// The chance is that of seed `seed`, so the same cells give the same samples.
  DecayBootstrap(std::span<const FitCell> cells, std::uint64_t seed, std::size_t samples = 1000);

  /// `value` with the interval that holds 95 of 100 samples' figures.
  [[nodiscard]] Estimate a(double value) const;
  [[nodiscard]] Estimate b(double value) const;
  [[nodiscard]] Estimate c(double value) const;
  /// The same for the curve's height at `x`.
  [[nodiscard]] Estimate at(double x, double value) const;

 private:
  std::vector<Decay> curves_;
};

}  // namespace tacit
