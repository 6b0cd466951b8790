#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace tacit {

/// a e^(-b x) + c
struct Decay {
  double a = 0.0;
  double b = 0.0;
  double c = 0.0;
  [[nodiscard]] double at(double x) const;
};

/// What was measured at one x under the same conditions. Cells of one block share an environment.
struct FitCell {
  double x = 0.0;
  std::size_t block = 0;
  std::vector<double> values;  ///< At least one.
};

/// A decay by least squares over the cells' means, and how well it does.
///
/// Blocks are of no interest here: from each mean that of its block is taken and the overall one
/// put back, so `r_squared` is the share of the variation within blocks that the curve explains.
/// The AIC (Akaike 1974), smaller is better, is n ln(RSS / n) + 2 k for n cells; every model pays
/// for its own parameters, for the blocks' levels and for the variance.
struct DecayFit {
  Decay curve;
  double r_squared = 0.0;
  double aic = 0.0;
  double aic_line = 0.0;      ///< Of a straight line through the same means.
  double aic_constant = 0.0;  ///< Of no dependence on x.
};

/// Absent below four different x, and when all means are the same.
///
/// For a given b the best a and c are those of a straight line in e^(-b x), so only b is sought
/// (variable projection; Golub & Pereyra 1973): on a grid from all but straight to all but a step,
/// then by golden sections. It needs no first guess and cannot diverge.
[[nodiscard]] std::optional<DecayFit> fit_decay(std::span<const FitCell> cells);

/// The curve of that fit alone; absent below four different x.
[[nodiscard]] std::optional<Decay> decay_curve(std::span<const FitCell> cells);

}  // namespace tacit
