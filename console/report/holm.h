#pragma once

#include <span>
#include <vector>

namespace tacit {

/// P-values of several tests, corrected so that the chance of even one false alarm among them
/// stays at the level they are compared with (Holm 1979); in the order given, at most 1.
[[nodiscard]] std::vector<double> holm_corrected(std::span<const double> p_values);

}  // namespace tacit
