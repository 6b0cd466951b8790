#include "console/report/estimate.h"

#include <algorithm>
#include <boost/math/distributions/binomial.hpp>
#include <boost/math/distributions/normal.hpp>
#include <boost/math/distributions/students_t.hpp>
#include <cassert>
#include <cmath>
#include <vector>

namespace tacit {
namespace {

constexpr double kOneSidedRisk = 0.025;

double t_quantile(double degrees) {
  return boost::math::quantile(
      boost::math::complement(boost::math::students_t(degrees), kOneSidedRisk));
}

/// The mean of a sample and how well it is known.
struct Sample {
  double mean;
  double variance_of_mean;
  double degrees;  ///< Of freedom.
};

std::optional<Sample> sample_of(std::span<const double> values) {
  const auto deviation = standard_deviation(values);
  if (!deviation) {
    return std::nullopt;
  }
  const auto count = static_cast<double>(values.size());
  return Sample{*mean(values), *deviation * *deviation / count, count - 1.0};
}

std::vector<double> sorted(std::span<const double> values) {
  std::vector<double> in_order(values.begin(), values.end());
  std::sort(in_order.begin(), in_order.end());
  return in_order;
}

double middle_of(const std::vector<double>& in_order) {
  const std::size_t half = in_order.size() / 2;
  return in_order.size() % 2 == 1 ? in_order[half] : (in_order[half - 1] + in_order[half]) / 2.0;
}

/// How many values may be left out at either end of a sample so that the rest still holds the
/// median; absent when not even the whole sample is sure enough to.
std::optional<std::size_t> left_out(std::size_t count) {
  const boost::math::binomial halves(static_cast<double>(count), 0.5);
  std::optional<std::size_t> most;
  for (std::size_t k = 0; k < count / 2; ++k) {
    if (boost::math::cdf(halves, static_cast<double>(k)) > kOneSidedRisk) break;
    most = k;
  }
  return most;
}

/// Degrees of freedom of the sum of two estimated variances (Satterthwaite 1946).
double joint_degrees(double variance_a, double degrees_a, double variance_b, double degrees_b) {
  const double sum = variance_a + variance_b;
  return sum * sum / (variance_a * variance_a / degrees_a + variance_b * variance_b / degrees_b);
}

/// A difference known with this variance and these degrees of freedom.
std::optional<Difference> tested(double value, double variance, double degrees) {
  if (variance <= 0.0) {
    return std::nullopt;
  }
  const double error = std::sqrt(variance);
  const double reach = t_quantile(degrees) * error;
  const boost::math::students_t distribution(degrees);
  const double tail =
      boost::math::cdf(boost::math::complement(distribution, std::fabs(value) / error));
  return Difference{{value, value - reach, value + reach}, 2.0 * tail};
}

std::vector<double> differences(std::span<const double> a, std::span<const double> b) {
  std::vector<double> differences(std::min(a.size(), b.size()));
  for (std::size_t i = 0; i < differences.size(); ++i) {
    differences[i] = a[i] - b[i];
  }
  return differences;
}

}  // namespace

std::optional<double> mean(std::span<const double> values) {
  if (values.empty()) {
    return std::nullopt;
  }
  double sum = 0.0;
  for (const double value : values) {
    sum += value;
  }
  return sum / static_cast<double>(values.size());
}

std::optional<double> standard_deviation(std::span<const double> values) {
  if (values.size() < 2) {
    return std::nullopt;
  }
  const double centre = *mean(values);
  double squares = 0.0;
  for (const double value : values) {
    squares += (value - centre) * (value - centre);
  }
  return std::sqrt(squares / static_cast<double>(values.size() - 1));
}

std::optional<Estimate> mean_estimate(std::span<const double> values) {
  const auto sample = sample_of(values);
  if (!sample) {
    return std::nullopt;
  }
  const double reach = t_quantile(sample->degrees) * std::sqrt(sample->variance_of_mean);
  return Estimate{sample->mean, sample->mean - reach, sample->mean + reach};
}

std::optional<Difference> welch_difference(std::span<const double> a, std::span<const double> b) {
  const auto sample_a = sample_of(a);
  const auto sample_b = sample_of(b);
  if (!sample_a || !sample_b) {
    return std::nullopt;
  }
  const double variance = sample_a->variance_of_mean + sample_b->variance_of_mean;
  const double degrees = joint_degrees(sample_a->variance_of_mean, sample_a->degrees,
                                       sample_b->variance_of_mean, sample_b->degrees);
  return tested(sample_a->mean - sample_b->mean, variance, degrees);
}

std::optional<Difference> paired_difference(std::span<const double> a, std::span<const double> b) {
  const auto sample = sample_of(differences(a, b));
  return sample ? tested(sample->mean, sample->variance_of_mean, sample->degrees) : std::nullopt;
}

std::optional<double> paired_effect(std::span<const double> a, std::span<const double> b) {
  const std::vector<double> pairs = differences(a, b);
  const std::optional<double> deviation = standard_deviation(pairs);
  return deviation && *deviation > 0.0 ? std::optional(*mean(pairs) / *deviation) : std::nullopt;
}

std::optional<Estimate> ratio_estimate(std::span<const double> a, std::span<const double> b) {
  const auto top = sample_of(a);
  const auto bottom = sample_of(b);
  if (!top || !bottom || bottom->mean == 0.0) {
    return std::nullopt;
  }
  const double ratio = top->mean / bottom->mean;
  const double bottom_share = ratio * ratio * bottom->variance_of_mean;
  if (top->variance_of_mean + bottom_share <= 0.0) {
    return Estimate{ratio, ratio, ratio};
  }
  const double t =
      t_quantile(joint_degrees(top->variance_of_mean, top->degrees, bottom_share, bottom->degrees));
  // The bounds are the roots of square r^2 - 2 half r + rest = 0.
  const double square = bottom->mean * bottom->mean - t * t * bottom->variance_of_mean;
  const double half = top->mean * bottom->mean;
  const double rest = top->mean * top->mean - t * t * top->variance_of_mean;
  if (square <= 0.0) {
    return std::nullopt;
  }
  const double root = std::sqrt(std::max(0.0, half * half - square * rest));
  return Estimate{ratio, (half - root) / square, (half + root) / square};
}

std::optional<Estimate> share_estimate(std::size_t successes, std::size_t count) {
  assert(successes <= count);
  if (count == 0) {
    return std::nullopt;
  }
  const double z =
      boost::math::quantile(boost::math::complement(boost::math::normal(), kOneSidedRisk));
  const auto n = static_cast<double>(count);
  const double share = static_cast<double>(successes) / n;
  const double weight = z * z / n;
  const double centre = (share + weight / 2.0) / (1.0 + weight);
  const double reach = std::sqrt(weight * (share * (1.0 - share) + weight / 4.0)) / (1.0 + weight);
  // Rounding must not exclude what was found.
  return Estimate{share, successes == 0 ? 0.0 : centre - reach,
                  successes == count ? 1.0 : centre + reach};
}

std::optional<double> median(std::span<const double> values) {
  return values.empty() ? std::nullopt : std::optional(middle_of(sorted(values)));
}

std::optional<Estimate> median_estimate(std::span<const double> values) {
  const std::optional<std::size_t> out = left_out(values.size());
  if (!out) {
    return std::nullopt;
  }
  const std::vector<double> in_order = sorted(values);
  return Estimate{middle_of(in_order), in_order[*out], in_order[in_order.size() - 1 - *out]};
}

Estimate scaled(const Estimate& estimate, double factor) {
  const double low = factor * estimate.low;
  const double high = factor * estimate.high;
  return {factor * estimate.value, std::min(low, high), std::max(low, high)};
}

}  // namespace tacit
