#pragma once

#include <cstddef>
#include <optional>
#include <span>

namespace tacit {

/// A figure and the interval that holds the true one in 95 of 100 such experiments.
struct Estimate {
  double value = 0.0;
  double low = 0.0;
  double high = 0.0;
  friend bool operator==(const Estimate&, const Estimate&) = default;
};

/// Of no values there is none.
[[nodiscard]] std::optional<double> mean(std::span<const double> values);
/// Of the population, estimated from the sample (n - 1); absent below two values.
[[nodiscard]] std::optional<double> standard_deviation(std::span<const double> values);

/// The mean with its Student-t interval; absent below two values.
[[nodiscard]] std::optional<Estimate> mean_estimate(std::span<const double> values);

/// What mean(a) - mean(b) is, and how likely so large a difference is if there is none.
struct Difference {
  Estimate estimate;
  double p_value = 1.0;  ///< Two-sided.
};

/// For independent samples whose variances may differ (Welch 1947). Absent when a sample has fewer
/// than two values, or when neither varies.
[[nodiscard]] std::optional<Difference> welch_difference(std::span<const double> a,
                                                         std::span<const double> b);

/// For samples whose values belong together, a[i] with b[i]; the longer one's rest is left out.
/// Absent below two pairs, or when all differ by the same.
[[nodiscard]] std::optional<Difference> paired_difference(std::span<const double> a,
                                                          std::span<const double> b);

/// The mean of the differences a[i] - b[i] in standard deviations of theirs (Cohen's d_z, 1988).
/// Absent as `paired_difference` is.
[[nodiscard]] std::optional<double> paired_effect(std::span<const double> a,
                                                  std::span<const double> b);

/// mean(a) / mean(b) for independent samples, by Fieller's theorem (1954) with the degrees of
/// freedom of Welch and Satterthwaite. Absent when a sample has fewer than two values, or when
/// mean(b) cannot be told from 0, so that no interval bounds the ratio.
[[nodiscard]] std::optional<Estimate> ratio_estimate(std::span<const double> a,
                                                     std::span<const double> b);

/// The share of successes among `count` trials with its Wilson interval (1927), which stays within
/// 0 and 1 and means something for none and for all; absent without trials. `successes` is at most
/// `count`.
[[nodiscard]] std::optional<Estimate> share_estimate(std::size_t successes, std::size_t count);

/// The median with the tightest pair of values, equally many from either end, that holds the true
/// one in at least 95 of 100 samples, whatever the distribution; absent below six values, of which
/// no pair does. A median of fewer is `median`.
[[nodiscard]] std::optional<Estimate> median_estimate(std::span<const double> values);
/// Of an even number of values the mean of the middle two; of none there is none.
[[nodiscard]] std::optional<double> median(std::span<const double> values);

/// `estimate` times `factor`.
[[nodiscard]] Estimate scaled(const Estimate& estimate, double factor);

}  // namespace tacit
