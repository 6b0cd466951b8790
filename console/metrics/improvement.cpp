#include "console/metrics/improvement.h"

namespace tacit {

std::optional<double> improvement_ratio(std::optional<double> p_n_m, std::uint32_t n,
                                        std::optional<double> p_1_m) {
  if (!p_n_m || !p_1_m || n == 0 || *p_1_m <= 0.0) {
    return std::nullopt;
  }
  return *p_n_m / (static_cast<double>(n) * *p_1_m);
}

}  // namespace tacit
