#include "console/report/estimate.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <vector>

#include "idl/types/random.h"

namespace tacit {
namespace {

// Student, "The probable error of a mean", Biometrika 6 (1908): hours of sleep gained by ten
// patients with each of two drugs. The intervals and p-values are those of R's documentation of
// t.test and of textbooks that use these figures.
const std::vector<double> kDrug1{0.7, -1.6, -0.2, -1.2, -0.1, 3.4, 3.7, 0.8, 0.0, 2.0};
const std::vector<double> kDrug2{1.9, 0.8, 1.1, 0.1, -0.1, 4.4, 5.5, 1.6, 4.6, 3.4};

std::vector<double> sample(Stream& stream, std::size_t count, double centre) {
  std::vector<double> values(count);
  for (double& value : values) {
    value = centre + stream.normal();
  }
  return values;
}

TEST(Mean, OfNothingIsAbsent) { EXPECT_EQ(mean({}), std::nullopt); }

TEST(StandardDeviation, DividesByOneLessThanTheCount) {
  EXPECT_EQ(standard_deviation(std::array{1.0, 3.0}), std::sqrt(2.0));
}

TEST(StandardDeviation, OfOneValueIsAbsent) {
  EXPECT_EQ(standard_deviation(std::array{1.0}), std::nullopt);
}

TEST(MeanEstimate, OfOneValueIsAbsent) { EXPECT_EQ(mean_estimate(std::array{1.0}), std::nullopt); }

// Upper critical values of Student's t for 0.975: NIST/SEMATECH e-Handbook, section 1.3.6.7.2.
TEST(MeanEstimate, ReachesAsFarAsTabulated) {
  const std::vector<std::pair<std::size_t, double>> table{{1, 12.706}, {2, 4.303},  {4, 2.776},
                                                          {9, 2.262},  {30, 2.042}, {99, 1.984}};
  for (const auto& [degrees, critical] : table) {
    Stream stream(1, "estimate", degrees);
    const std::vector<double> values = sample(stream, degrees + 1, 5.0);
    const Estimate estimate = mean_estimate(values).value();
    const double error =
        *standard_deviation(values) / std::sqrt(static_cast<double>(values.size()));
    EXPECT_NEAR((estimate.high - estimate.value) / error, critical, 5e-4) << degrees;
    EXPECT_NEAR((estimate.value - estimate.low) / error, critical, 5e-4) << degrees;
  }
}

TEST(MeanEstimate, HoldsTheTrueMeanInNineteenOfTwentyExperiments) {
  Stream stream(2, "estimate");
  int held = 0;
  for (int experiment = 0; experiment < 4000; ++experiment) {
    const Estimate estimate = mean_estimate(sample(stream, 5, 3.0)).value();
    held += estimate.low < 3.0 && 3.0 < estimate.high ? 1 : 0;
  }
  EXPECT_NEAR(held / 4000.0, 0.95, 0.015);
}

TEST(WelchDifference, IsAsPublishedForStudentsSleepers) {
  const Difference difference = welch_difference(kDrug1, kDrug2).value();

  EXPECT_NEAR(difference.estimate.value, -1.58, 1e-12);
  EXPECT_NEAR(difference.estimate.low, -3.3654832, 1e-7);
  EXPECT_NEAR(difference.estimate.high, 0.2054832, 1e-7);
  EXPECT_NEAR(difference.p_value, 0.07939, 5e-6);
}

TEST(WelchDifference, TurnsWithItsSamples) {
  const Difference there = welch_difference(kDrug1, kDrug2).value();
  const Difference back = welch_difference(kDrug2, kDrug1).value();

  EXPECT_DOUBLE_EQ(there.estimate.low, -back.estimate.high);
  EXPECT_DOUBLE_EQ(there.p_value, back.p_value);
}

TEST(WelchDifference, OfTwoConstantsIsAbsent) {
  EXPECT_FALSE(welch_difference(std::array{1.0, 1.0}, std::array{2.0, 2.0}).has_value());
}

TEST(WelchDifference, TakesASampleThatDoesNotVary) {
  const Difference difference =
      welch_difference(std::array{100.0, 100.0, 100.0}, std::array{97.0, 98.0, 99.0}).value();

  EXPECT_EQ(difference.estimate.value, 2.0);
  EXPECT_NEAR(difference.estimate.high, 2.0 + 4.3026527 / std::sqrt(3.0), 1e-6);
}

TEST(PairedDifference, IsAsPublishedForStudentsSleepers) {
  const Difference difference = paired_difference(kDrug1, kDrug2).value();

  EXPECT_NEAR(difference.estimate.low, -2.4598858, 1e-7);
  EXPECT_NEAR(difference.estimate.high, -0.7001142, 1e-7);
  EXPECT_NEAR(difference.p_value, 0.002833, 5e-7);
}

TEST(PairedDifference, NeedsTwoPairsThatDifferDifferently) {
  EXPECT_FALSE(paired_difference(std::array{1.0}, std::array{2.0, 3.0}).has_value());
  EXPECT_FALSE(paired_difference(std::array{1.0, 2.0}, std::array{2.0, 3.0}).has_value());
}

// 1.58 / 1.2299593, the mean of the published differences in standard deviations of theirs.
TEST(PairedEffect, IsTheMeanDifferenceInStandardDeviations) {
  EXPECT_NEAR(paired_effect(kDrug2, kDrug1).value(), 1.2845585, 1e-6);
}

TEST(PairedEffect, OfDifferencesThatDoNotVaryIsAbsent) {
  EXPECT_FALSE(paired_effect(std::array{1.0, 2.0}, std::array{0.0, 1.0}).has_value());
}

TEST(RatioEstimate, OverAConstantIsTheMeanEstimateDividedByIt) {
  const Estimate over_four = ratio_estimate(kDrug2, std::array{4.0, 4.0}).value();
  const Estimate plain = mean_estimate(kDrug2).value();

  EXPECT_DOUBLE_EQ(over_four.value, plain.value / 4.0);
  EXPECT_NEAR(over_four.low, plain.low / 4.0, 1e-12);
  EXPECT_NEAR(over_four.high, plain.high / 4.0, 1e-12);
}

TEST(RatioEstimate, TurnedOverIsTheEstimateOfTheOtherRatio) {
  Stream stream(3, "estimate");
  const auto a = sample(stream, 8, 20.0);
  const auto b = sample(stream, 12, 9.0);
  const Estimate there = ratio_estimate(a, b).value();
  const Estimate back = ratio_estimate(b, a).value();

  EXPECT_NEAR(there.value, 1.0 / back.value, 1e-12);
  EXPECT_NEAR(there.low, 1.0 / back.high, 1e-12);
  EXPECT_NEAR(there.high, 1.0 / back.low, 1e-12);
}

TEST(RatioEstimate, HoldsTheTrueRatioInNineteenOfTwentyExperiments) {
  Stream stream(4, "estimate");
  int held = 0;
  for (int experiment = 0; experiment < 4000; ++experiment) {
    const auto a = sample(stream, 20, 12.0);
    const auto b = sample(stream, 10, 6.0);
    const Estimate estimate = ratio_estimate(a, b).value();
    held += estimate.low < 2.0 && 2.0 < estimate.high ? 1 : 0;
  }
  EXPECT_NEAR(held / 4000.0, 0.95, 0.015);
}

TEST(RatioEstimate, IsAbsentOverWhatCannotBeToldFromZero) {
  EXPECT_EQ(ratio_estimate(kDrug2, std::array{-1.0, 1.1}), std::nullopt);
}

// Newcombe, "Two-sided confidence intervals for the single proportion", Statistics in Medicine 17
// (1998), table I, method 3, and R's binom.confint(…, methods = "wilson").
TEST(ShareEstimate, GivesWilsonsLimits) {
  const auto expect = [](std::size_t successes, std::size_t count, double low, double high) {
    const Estimate found = share_estimate(successes, count).value();
    EXPECT_DOUBLE_EQ(found.value, static_cast<double>(successes) / static_cast<double>(count));
    EXPECT_NEAR(found.low, low, 5e-5);
    EXPECT_NEAR(found.high, high, 5e-5);
  };
  expect(81, 263, 0.2553, 0.3662);
  expect(15, 148, 0.0624, 0.1605);
  expect(0, 20, 0.0, 0.1611);
  expect(1, 29, 0.0061, 0.1718);
  expect(0, 10, 0.0, 0.2775);
  expect(10, 10, 0.7225, 1.0);
  expect(7, 10, 0.3968, 0.8922);
}

TEST(ShareEstimate, StaysWithinZeroAndOne) {
  for (std::size_t count = 1; count < 300; ++count) {
    EXPECT_EQ(share_estimate(0, count).value().low, 0.0);
    EXPECT_EQ(share_estimate(count, count).value().high, 1.0);
  }
}

TEST(ShareEstimate, OfNothingIsAbsent) { EXPECT_EQ(share_estimate(0, 0), std::nullopt); }

TEST(Median, LiesInTheMiddleWhateverTheOrder) {
  EXPECT_EQ(median(std::array{5.0, 1.0, 2.0}), 2.0);
  EXPECT_EQ(median(std::array{5.0, 1.0, 2.0, 3.0}), 2.5);
  EXPECT_EQ(median({}), std::nullopt);
}

// Conover, Practical Nonparametric Statistics (1999), table A3: of ten values the second and the
// ninth, of twenty the sixth and the fifteenth.
TEST(MedianEstimate, LeavesOutWhatTheBinomialAllows) {
  std::vector<double> values;
  for (int i = 20; i >= 1; --i) {
    values.push_back(i);
  }
  EXPECT_EQ(median_estimate(values), (Estimate{10.5, 6.0, 15.0}));
  values.erase(values.begin(), values.begin() + 10);
  EXPECT_EQ(median_estimate(values), (Estimate{5.5, 2.0, 9.0}));
  values.erase(values.begin(), values.begin() + 4);
  EXPECT_EQ(median_estimate(values), (Estimate{3.5, 1.0, 6.0}));
  values.pop_back();
  EXPECT_EQ(median_estimate(values), std::nullopt);
}

TEST(Scaled, KeepsTheIntervalInOrder) {
  EXPECT_EQ(scaled({2.0, 1.0, 4.0}, -0.5), (Estimate{-1.0, -2.0, -0.5}));
}

}  // namespace
}  // namespace tacit
