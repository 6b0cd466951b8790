#include "console/report/decay_fit.h"

#include <gtest/gtest.h>

#include "console/report/decay_bootstrap.h"
#include "console/report/exponential.h"
#include "idl/types/random.h"

namespace tacit {
namespace {

constexpr Decay kTrue{400.0, 0.35, 30.0};

/// Six team sizes in `blocks` environments, each with a level of its own, three values a cell.
std::vector<FitCell> cells(std::size_t blocks, double noise, const Decay& curve = kTrue) {
  Stream chance(5, "decay");
  std::vector<FitCell> all;
  for (std::size_t block = 0; block < blocks; ++block) {
    for (const double x : {2.0, 4.0, 6.0, 8.0, 10.0, 12.0}) {
      FitCell cell{x, block, {}};
      for (int i = 0; i < 3; ++i) {
        const double level =
            40.0 * (static_cast<double>(block) - static_cast<double>(blocks - 1) / 2.0);
        cell.values.push_back(curve.at(x) + level + noise * chance.normal());
      }
      all.push_back(cell);
    }
  }
  return all;
}

TEST(Exponential, IsEToThePower) {
  EXPECT_EQ(exponential(0.0), 1.0);
  EXPECT_NEAR(exponential(1.0), 2.718281828459045, 1e-15);
  EXPECT_NEAR(exponential(-20.5) / 1.2501528663867426e-09, 1.0, 1e-14);
  EXPECT_NEAR(exponential(300.25) / 2.4941248615349213e+130, 1.0, 1e-13);
  EXPECT_EQ(exponential(-1e9), 0.0);
}

TEST(DecayFit, FindsACurveWithoutNoise) {
  const DecayFit fit = fit_decay(cells(1, 0.0)).value();
  EXPECT_NEAR(fit.curve.a, kTrue.a, 1e-4);
  EXPECT_NEAR(fit.curve.b, kTrue.b, 1e-6);
  EXPECT_NEAR(fit.curve.c, kTrue.c, 1e-4);
  EXPECT_NEAR(fit.r_squared, 1.0, 1e-9);
}

TEST(DecayFit, IsNotMisledByWhatSetsEnvironmentsApart) {
  const DecayFit fit = fit_decay(cells(7, 0.0)).value();
  EXPECT_NEAR(fit.curve.b, kTrue.b, 1e-6);
  EXPECT_NEAR(fit.r_squared, 1.0, 1e-9);
}

TEST(DecayFit, IsPreferredWhereThereIsADecay) {
  const DecayFit fit = fit_decay(cells(7, 5.0)).value();
  EXPECT_LT(fit.aic, fit.aic_line);
  EXPECT_LT(fit.aic, fit.aic_constant);
}

TEST(DecayFit, IsNotPreferredWhereNothingChanges) {
  const DecayFit fit = fit_decay(cells(7, 5.0, {0.0, 1.0, 100.0})).value();
  EXPECT_LT(fit.aic_constant, fit.aic);
}

TEST(DecayFit, NeedsFourDifferentX) {
  std::vector<FitCell> three = cells(1, 1.0);
  three.resize(3);
  EXPECT_FALSE(fit_decay(three).has_value());
}

TEST(DecayBootstrap, HoldsTheTrueParameters) {
  const std::vector<FitCell> measured = cells(7, 10.0);
  const DecayFit fit = fit_decay(measured).value();
  const DecayBootstrap bootstrap(measured, 1);
  const Estimate a = bootstrap.a(fit.curve.a);
  const Estimate b = bootstrap.b(fit.curve.b);
  EXPECT_LT(a.low, kTrue.a);
  EXPECT_GT(a.high, kTrue.a);
  EXPECT_LT(b.low, kTrue.b);
  EXPECT_GT(b.high, kTrue.b);
}

TEST(DecayBootstrap, WidensWithTheNoise) {
  const auto reach = [](double noise) {
    const Estimate band = DecayBootstrap(cells(1, noise), 1).at(6.0, kTrue.at(6.0));
    return band.high - band.low;
  };
  EXPECT_GT(reach(20.0), 5.0 * reach(2.0));
}

TEST(DecayBootstrap, GivesTheSameForTheSameSeedOnly) {
  const std::vector<FitCell> measured = cells(3, 10.0);
  EXPECT_EQ(DecayBootstrap(measured, 1).b(0.0), DecayBootstrap(measured, 1).b(0.0));
  EXPECT_NE(DecayBootstrap(measured, 1).b(0.0), DecayBootstrap(measured, 2).b(0.0));
}

}  // namespace
}  // namespace tacit
