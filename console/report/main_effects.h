#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace tacit {

/// A value and the level of every factor under which it was seen.
struct Observation {
  double value = 0.0;
  std::vector<std::size_t> levels;  ///< One per factor; as many in every observation.
};

/// How much of the variation one factor accounts for by itself.
struct MainEffect {
  double eta_squared = 0.0;  ///< Share of the total sum of squares.
  std::size_t degrees = 0;   ///< Of freedom.
  double mean_square = 0.0;
  std::optional<double> f;        ///< Against the residual; absent for it, and when it is 0.
  std::optional<double> p_value;  ///< Of F.
};

/// The effects of the factors, in their order, and last the residual, which holds the interactions:
/// an analysis of variance by main effects. The shares add up to 1 when every combination of levels
/// was seen equally often. Empty when nothing varies or no degrees are left for the residual.
[[nodiscard]] std::vector<MainEffect> main_effects(std::span<const Observation> observations);

}  // namespace tacit
