#include "console/report/wilcoxon.h"

#include <algorithm>
#include <boost/math/distributions/normal.hpp>
#include <cmath>
#include <vector>

namespace tacit {
namespace {

constexpr std::size_t kExactPairs = 50;

/// What remains of a sample once its differences are ranked by size.
struct Ranks {
  std::size_t count = 0;
  double positive = 0.0;  ///< Sum of the ranks of positive differences.
  double ties = 0.0;      ///< Sum of t^3 - t over groups of t equal ranks.
};

std::vector<double> nonzero_differences(std::span<const double> a, std::span<const double> b) {
  std::vector<double> differences;
  for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i) {
    if (a[i] != b[i]) {
      differences.push_back(a[i] - b[i]);
    }
  }
  return differences;
}

Ranks ranks_of(std::vector<double> differences) {
  std::sort(differences.begin(), differences.end(),
            [](double x, double y) { return std::fabs(x) < std::fabs(y); });
  Ranks ranks{differences.size()};
  for (std::size_t first = 0; first < differences.size();) {
    std::size_t end = first;
    std::size_t positive = 0;
    for (; end < differences.size() && std::fabs(differences[end]) == std::fabs(differences[first]);
         ++end) {
      positive += differences[end] > 0.0 ? 1 : 0;
    }
    const auto equal = static_cast<double>(end - first);
    ranks.positive += static_cast<double>(positive) * static_cast<double>(first + end + 1) / 2.0;
    ranks.ties += equal * equal * equal - equal;
    first = end;
  }
  return ranks;
}

/// By counting the subsets of 1 … n with each sum.
double exact_p(const Ranks& ranks) {
  const std::size_t total = ranks.count * (ranks.count + 1) / 2;
  std::vector<double> share(total + 1);
  share[0] = 1.0;
  for (std::size_t rank = 1; rank <= ranks.count; ++rank) {
    for (std::size_t sum = total + 1; sum-- > 0;) {
      share[sum] = (share[sum] + (sum >= rank ? share[sum - rank] : 0.0)) / 2.0;
    }
  }
  const double smaller = std::min(ranks.positive, static_cast<double>(total) - ranks.positive);
  double tail = 0.0;
  for (std::size_t sum = 0; static_cast<double>(sum) <= smaller; ++sum) {
    tail += share[sum];
  }
  return std::min(1.0, 2.0 * tail);
}

double approximate_p(const Ranks& ranks) {
  const auto n = static_cast<double>(ranks.count);
  const double variance = n * (n + 1.0) * (2.0 * n + 1.0) / 24.0 - ranks.ties / 48.0;
  const double away = std::fabs(ranks.positive - n * (n + 1.0) / 4.0);
  const double z = std::max(0.0, away - 0.5) / std::sqrt(variance);
  return 2.0 * boost::math::cdf(boost::math::complement(boost::math::normal(), z));
}

}  // namespace

std::optional<double> wilcoxon_signed_rank(std::span<const double> a, std::span<const double> b) {
  const Ranks ranks = ranks_of(nonzero_differences(a, b));
  if (ranks.count == 0) {
    return std::nullopt;
  }
  const bool exact = ranks.count <= kExactPairs && ranks.ties == 0.0;
  return exact ? exact_p(ranks) : approximate_p(ranks);
}

}  // namespace tacit
