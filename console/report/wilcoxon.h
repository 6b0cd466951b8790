#pragma once

#include <optional>
#include <span>

namespace tacit {

/// How likely so uneven a split of the differences a[i] - b[i] about 0 is when their distribution
/// is symmetric about it: the two-sided p-value of the signed-rank test (Wilcoxon 1945). Pairs that
/// do not differ are left out. Exact up to 50 pairs without ties, else by the normal approximation
/// with corrections for ties and continuity. Absent when no pair differs.
[[nodiscard]] std::optional<double> wilcoxon_signed_rank(std::span<const double> a,
                                                         std::span<const double> b);

}  // namespace tacit
