#pragma once

#include <cstdint>
#include <optional>

namespace tacit {

/// P(n) / (n P(1)): what n robots achieve over n times what one achieves, where P is the mean
/// distance of enemy death. Above 1 the team is worth more than its robots. Absent when a P is
/// absent, `n` is 0 or P(1) is not positive.
[[nodiscard]] std::optional<double> improvement_ratio(std::optional<double> p_n_m, std::uint32_t n,
                                                      std::optional<double> p_1_m);

}  // namespace tacit
