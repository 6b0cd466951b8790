#include "console/report/holm.h"

#include <algorithm>
#include <numeric>

namespace tacit {

std::vector<double> holm_corrected(std::span<const double> p_values) {
  std::vector<std::size_t> rising(p_values.size());
  std::iota(rising.begin(), rising.end(), 0);
  std::stable_sort(rising.begin(), rising.end(),
                   [&](std::size_t a, std::size_t b) { return p_values[a] < p_values[b]; });
  std::vector<double> corrected(p_values.size());
  double largest = 0.0;
  std::size_t still_to_pass = p_values.size();
  for (const std::size_t i : rising) {
    largest = std::max(largest, static_cast<double>(still_to_pass) * p_values[i]);
    corrected[i] = std::min(1.0, largest);
    --still_to_pass;
  }
  return corrected;
}

}  // namespace tacit
